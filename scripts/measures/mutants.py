# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that can fail: changes the product in many places, one at a time, and tells which changes no test notices. All
changes are compiled at once and switched on by number (mutant.h), so that there is one build. A change is tried on the
tests that reach it, those that take least first, until one fails."""

import collections
import concurrent.futures
import datetime
import hashlib
import json
import os
import random
import re
import subprocess
import threading
import types

from environment import packages
from environment.build import CHECKOUT, build_folder, compile_targets, configure, ensure_toolchain, processors
from environment.messages import Failure, output, say

ROOMS = {"laplacian_lines": ["core_tests"], "mesh_files": ["mesh_files_tests"], "line_drawing": ["line_drawing_tests"],
         "line_renderer": ["line_renderer_tests"],
         "meshlab_host": ["host_tests", "decoration_tests"], "filter_laplacian_lines": ["host_tests"],
         "decorate_laplacian_lines": ["decoration_tests", "host_tests"],
         "programs/drawing_program": ["laplacian_lines_drawing"]}  # and targets whose tests see it
# These build, need a display or the network, or look at sources.
NOT_RUN = r"meshlab\.|Installed|OutOfMemory|Rooms|benchmarks|wheel|scripts|line_renderer\.o|line_drawing\.(others|dask)"
ORDER = ["statement", "condition", "return", "sign", "constant", "comparison"]  # from outside to inside, at one place
OVERTIME = -24, -9, 124, 137, 152  # of the processor, killed, by the clock, and as shells tell it
BATCHES = 1, 10, 100, 1e9  # seconds of tests that run in one process, one batch after the other
NIGHTLY_COUNT, NIGHTLY_MOST = 24, 60  # mutants a night, and seconds of tests for each
LEAST_NOTICED = 0.6  # of those that a test reaches: about 85 % are, and most others make no difference


def run(rooms, count, seed, most):
    """Counts mutants by fate. A mutant's tests together take at most this much processor time."""
    rooms = rooms or list(ROOMS)
    if unknown := [room for room in rooms if room not in ROOMS]:
        raise Failure(f"{unknown[0]} is no room with mutants: {' '.join(ROOMS)}")
    folder = build_folder() / "mutants"
    ensure_toolchain(*packages.TEST, "clang", "python3-clang")
    copy_sources(folder / "tree")
    places = choose(find_places(folder, [f"{room}/" for room in rooms]), count, seed)
    build(folder, places, sorted({target for room in rooms for target in ROOMS[room]}))
    tests = Tests(folder, len(places))
    say("trying mutants")
    with concurrent.futures.ThreadPoolExecutor(processors()) as pool, (folder / "log").open("w") as log:
        def attempt(number):
            if not places[number]:
                return None
            fate = tests.fate(number, most)
            print(row(number, places[number], fate), file=log, flush=True)
            return fate

        fates = list(pool.map(attempt, range(len(places))))
    return tell(folder / "table.tsv", places, fates, tests)


def run_nightly():
    """A few mutants of all rooms, others each night."""
    fates = run([], NIGHTLY_COUNT, datetime.date.today().isoformat(), NIGHTLY_MOST)
    noticed, survived = fates["killed"] + fates["timed out"], fates["survived"]
    if noticed < LEAST_NOTICED * (noticed + survived) or not noticed:
        raise Failure(f"tests notice only {noticed} of {noticed + survived} changes that they see")
    return f"{noticed} of {noticed + survived} changes were noticed"


def copy_sources(tree):
    for name in output("git", "-C", CHECKOUT, "ls-files", "-z").split("\0"):
        if name and (CHECKOUT / name).is_file():
            copy(tree / name, (CHECKOUT / name).read_bytes(), CHECKOUT / name)


def copy(target, data, like):
    """Does not recompile what has not changed."""
    if not target.exists() or target.read_bytes() != data:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
        target.chmod(like.stat().st_mode)


def find_places(folder, rooms):
    # like ./test, so that ccache has what holds no mutant
    configure(folder / "tree", folder / "tree/build", ["--preset", "tests", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"])
    database = folder / "commands.json"  # of the sources as they are
    database.write_text((folder / "tree/build/compile_commands.json").read_text().replace(
        str(folder / "tree") + "/", f"{CHECKOUT}/").replace(f"{CHECKOUT}/build/", f"{folder}/tree/build/"))
    say("reading the sources")
    # Debian's, which has the package
    found = output("/usr/bin/python3", "-B", CHECKOUT / "scripts/measures/mutant_places.py", CHECKOUT, database, *rooms)
    if not found:
        raise Failure("mutant_places.py failed")
    return [types.SimpleNamespace(**place) for place in json.loads(found)]


def choose(places, count, seed):
    """Equally many per file, and per kind within a file. A file's depend on that file alone."""
    files = {}
    for place in sorted(places, key=lambda place: (place.file, place.edits)):
        files.setdefault(place.file, {}).setdefault(place.kind, []).append(place)
    orders = []
    for file, kinds in files.items():
        chance, order = random.Random(f"{seed} {file}"), []
        for found in kinds.values():
            chance.shuffle(found)
        while any(kinds.values()):
            order += [kinds[kind].pop() for kind in chance.sample(sorted(kinds), len(kinds)) if kinds[kind]]
        orders.append((hashlib.sha256(f"{seed} {file}".encode()).digest(), order))
    rounds = [order[turn] for turn in range(max(map(len, (order for _, order in orders)), default=0))
              for _, order in sorted(orders, key=lambda entry: entry[0]) if turn < len(order)]
    say(f"{len(rounds)} places in {len(files)} files, of which {min(count, len(rounds))} are taken")
    return rounds[:count]


def build(folder, places, targets):
    """Leaves out, as None, what does not compile."""
    os.environ["MAKEFLAGS"] = "k"  # all errors at once
    files = {place.file for place in places if place}
    while True:
        for file in files:
            copy(folder / "tree" / file, mutated(file, places), CHECKOUT / file)
        say(f"compiling {sum(map(bool, places))} mutants")
        try:
            return compile_targets(folder / "tree", folder / "tree/build", targets)
        except Failure:
            log = (folder / "tree/build/build.log").read_text()
            lines = re.findall(r"(?m)^.*(?:error:|required from).*$", log)
            named = {(file, int(line)) for text in lines for file, line in re.findall(r"tree/([\w./]+):(\d+)", text)}
            wrong = [number for number, place in enumerate(places) if place and any(
                file == place.file and place.lines[0] <= line <= place.lines[1] for file, line in named)]
            if not wrong:
                raise
            for number in wrong:
                places[number] = None


def mutated(file, places):
    edits = []
    for number, place in enumerate(places):
        if place and place.file == file:
            size, last = place.edits[-1][1] - place.edits[0][0], len(place.edits) - 1
            nesting = -size, ORDER.index(place.kind)  # outer ones first where they begin, last where they end
            for part, (begin, end, text) in enumerate(place.edits):
                ends = part == last and part > 0
                key = (begin, 0, size, -nesting[1]) if ends else (begin, 1, *nesting)
                edits.append((key, begin, end, text.replace("@", str(number))))
    data, place, done = (CHECKOUT / file).read_bytes(), 0, b""
    for _, begin, end, text in sorted(edits):
        done += data[place:begin] + text.encode()
        place = end
    # like a system header, which gives no warnings
    return f'#include "{CHECKOUT}/scripts/measures/mutant.h"\n# 1 "/tree/{file}" 3\n'.encode() + done + data[place:]


class Tests:
    def __init__(self, folder, count):
        """Runs all once without a mutant: the time of each test, and the places it sees."""
        self.folder = folder
        for name in ("logs", "seen"):
            (folder / name).mkdir(exist_ok=True)
        listed = json.loads(output("ctest", "--test-dir", folder / "tree/build", "--show-only=json-v1"))["tests"]
        tests = [test for test in listed if os.path.exists(test.get("command", [""])[0]) and not re.match(
            NOT_RUN, test["name"]) and not any(entry["name"] == "DISABLED" for entry in test["properties"])]
        say(f"running {len(tests)} tests without a mutant")
        with concurrent.futures.ThreadPoolExecutor(processors()) as pool:
            self.all = list(filter(None, pool.map(lambda test: self.record(test, count), tests)))
        self.all.sort(key=lambda test: test["seconds"])
        say(f"{len(self.all)} passed; the others are left out")

    def record(self, test, count):
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        name = re.match("--gtest_filter=([^:]*)$", " ".join(test["command"][1:2]))
        test["in_program"], test["case"] = bool(name), name[1] if name else test["name"]
        test["environment"] = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
        seen = self.folder / "seen" / hashlib.sha256(test["name"].encode()).hexdigest()
        seen.write_bytes(bytes(1 << 16))
        code, seconds, _ = self.execute(test["command"], 1000, test["environment"],
                                        LAPLACIAN_LINES_MUTANTS_SEEN=str(seen))
        return {**test, "seconds": seconds, "seen": seen.read_bytes()[:count]} if code == 0 else None

    def execute(self, command, seconds, environment, **more):
        """Exit code, processor time and output. Ends what hangs or takes all memory."""
        log = self.folder / "logs" / str(threading.get_ident())
        with log.open("wb") as file:
            limits = ["timeout", "-k", "9", str(int(30 * seconds) + 60),
                      "prlimit", f"--cpu={int(seconds) + 1}", "--core=0", "--as=12000000000"]
            process = subprocess.Popen([*limits, *command],
                                       stdout=file, stderr=file, stdin=subprocess.DEVNULL,
                                       cwd=self.folder / "tree/build", env={**os.environ, **environment, **more})
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, usage.ru_utime + usage.ru_stime, log.read_text(errors="replace")

    def fate(self, number, most):
        """A mutant's fate, the test that noticed it, and the processor time of the tests tried: those that see it, up
        to a limit in seconds."""
        seeing, spent = [test for test in self.all if test["seen"][number]], 0
        for group in groups(list(seeing), most):
            program, *words = group[0]["command"]
            if group[0]["in_program"]:
                words = ["--gtest_filter=" + ":".join(test["case"] for test in group), "--gtest_fail_fast"]
            code, seconds, text = self.execute([program, *words], 10 + 5 * sum(test["seconds"] for test in group),
                                               group[0]["environment"], LAPLACIAN_LINES_MUTANT=str(number))
            spent += seconds
            if code:
                case = (re.findall(r"\[  FAILED  \] ([^\s,]+)", text)[:1] or
                        re.findall(r"\[ RUN      \] (\S+)", text)[-1:])  # where it ended
                return "timed out" if code in OVERTIME else "killed", (case or [group[0]["case"]])[0], spent
        return "survived" if seeing else "not reached", "", spent


def groups(tests, most):
    """Single-process tests, quickest first."""
    for longest in BATCHES:
        batch, taken = {}, 0
        while tests and tests[0]["seconds"] <= most and (not taken or taken + tests[0]["seconds"] <= longest):
            test = tests.pop(0)
            taken, most = taken + test["seconds"], most - test["seconds"]
            batch.setdefault((test["command"][0], str(test["environment"]), not test["in_program"] and test["case"]),
                             []).append(test)
        yield from batch.values()


def row(number, place, fate):
    what, noticed, seconds = fate
    return f"{what}\t{number}\t{place.file}:{place.lines[0]}\t{place.kind}\t{place.change}\t{noticed}\t{seconds:.0f}"


def tell(table, places, fates, tests):
    """Writes the tables, prints what survived, and counts fates."""
    pairs = [(place, fate) for place, fate in zip(places, fates) if fate]
    rows = [row(number, place, fates[number]) for number, place in enumerate(places) if place]
    table.write_text("fate\tnumber\tplace\tkind\tchange\tnoticed by\tseconds\n" + "\n".join(sorted(rows)) + "\n")
    noticing = {noticed for _, (_, noticed, _) in pairs}
    unneeded = [f"{test['seconds']:.2f}\t{test['case']}\n" for test in reversed(tests.all)
                if test["case"] not in noticing]
    table.with_name("unneeded.tsv").write_text("".join(unneeded))  # a test that takes less noticed all that they would
    print(table, table.with_name("unneeded.tsv"), sep="\n")
    print("\n".join(told for told in rows if told.startswith("survived")))
    for room in ROOMS:
        counts = collections.Counter(fate for place, (fate, *_) in pairs if place.file.startswith(f"{room}/"))
        if counts:
            print(f"{room}: " + ", ".join(f"{count} {fate}" for fate, count in sorted(counts.items())))
    return collections.Counter(fate for _, (fate, *_) in pairs)
