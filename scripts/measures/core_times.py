# SPDX-License-Identifier: GPL-3.0-or-later
"""Times of the core: the meshes, and building and running of programs/benchmarks."""

import json
import pathlib
import re
import tempfile

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import Failure, output, run, say
from product import models


def build_benchmarks(target, *extra_packages):
    """The program."""
    packages.ensure_packages(*packages.CORE, *extra_packages)
    say(f"building {target}")
    build_targets(target, preset="benchmarks")
    return build_folder() / "programs/benchmarks" / target


def table_models(*names, checkout=CHECKOUT):
    """Those available, or one of our own."""
    found = []
    for name in names:
        is_dragon = name.startswith("dragon")
        mesh = models.stanford_dragon(name[6:]) if is_dragon else models.model_beside(checkout, name)
        if mesh:
            found.append(mesh)
        elif is_dragon:
            say(f"left out: the model {name} cannot be fetched")
    return found or [models.kept_bumpy_torus()]


def commit():
    return output("git", "-C", CHECKOUT, "describe", "--always", "--dirty", "--abbrev=12") or "unknown"


def measure(program, *words):
    """Prints the table; all figures."""
    print(f"Commit {commit()}", flush=True)
    with tempfile.TemporaryDirectory() as work:
        figures = pathlib.Path(work, "figures")
        if run([program, "--json", figures, *words]) != 0:
            raise Failure("the table could not be made")
        return figures.read_text()


def measure_busy(meshes):
    """Prints tables of the main figures under load, and of commands for the last mesh."""
    program, write_mesh = build_benchmarks("busy_table"), build_benchmarks("write_mesh")
    with tempfile.TemporaryDirectory() as work:
        large = f"{work}/large.ply"
        if run([write_mesh, meshes[-1], "--refine", "2", large]) != 0:
            raise Failure("the large mesh could not be made")
        commands = {"./run --picture": f"--picture {work}/picture.png {meshes[-1]}",
                    "six views on paper": f"--drawing {work}/six.pdf --views six --unit m {meshes[-1]}",
                    "the same of 16 times the triangles": f"--drawing {work}/six.pdf --views six --unit m {large}"}
        words = [word for label, words in commands.items()
                 for word in ("--command", f"{label}={CHECKOUT}/run {words} >{work}/log 2>&1")]
        figures = measure(program, *words, *meshes)
    return f'{{"beside other work": {figures},\n"in_meshlab": {measure_in_meshlab(meshes[-1])}}}\n'


def measure_in_meshlab(mesh):
    """Prints a table of the plugins' times; returns the figures, "null" if left out."""
    for package in ("meshlab", "xvfb"):
        if packages.missing([package]):
            say(f"left out: times in MeshLab, for the package {package} is not installed")
            return "null"
    say("measuring in MeshLab")
    figures = output(CHECKOUT / "programs/benchmarks/in_meshlab.py", mesh)
    if figures is None:
        say("left out: times in MeshLab")
        return "null"
    print(f"\n| in MeshLab, {pathlib.Path(mesh).name} | |\n|---|--:|")
    for name, value in json.loads(figures).items():
        what, unit = name.rsplit("_", 1)
        print(f"| {what.replace('_', ' ')}, {unit} | {value} |")
    return figures


def count_instructions(program, mesh):
    """Prints instructions of redraws, and the memory they read: each begins with an empty cache that holds all it
    reads, so that misses are first reads."""
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        say("counting instructions and memory in callgrind: some minutes")
        with (work / "redraws").open("w") as redraws, (work / "log").open("w") as log:
            if run([program, "--prepare", work / "mesh", mesh], stdout=redraws, stderr=log) or run(
                    ["valgrind", "--tool=callgrind", "--instr-atstart=no", "--cache-sim=yes", "--LL=268435456,16,64",
                     f"--callgrind-out-file={work}/dump", program, work / "mesh"],
                    stdout=redraws, stderr=log):
                say("\n".join((work / "log").read_text().splitlines()[-5:]))
                raise Failure("the instructions could not be counted")
        dumps = "\n".join(file.read_text() for file in sorted(work.glob("dump*")))
        found = re.findall(
            r"^desc: Trigger: Client Request: (.*)\n(?:.*\n)*?events: (.*)\n(?:.*\n)*?totals: (.*)$", dumps, re.M)
        counts = {key: dict(zip(events.split(), map(int, totals.split()))) for key, events, totals in found}
        print("| | instructions a redraw, millions | a vertex | a triangle with a crossing "
              "| MB read | bytes read a vertex |\n|---|--:|--:|--:|--:|--:|")
        for line in (work / "redraws").read_text().splitlines():
            if line.count("\t") == 4:
                key, label, *numbers = line.split("\t")
                redraws, vertices, triangles = map(float, numbers)
                total, lines_read = (counts.get(key, {}).get(event, 0) for event in ("Ir", "DLmr"))
                crossed = f"{total / triangles:.0f}" if triangles else "–"
                print(f"| {label} | {total / redraws / 1e6:.1f} | {total / redraws / vertices:.0f} | {crossed} "
                      f"| {64 * lines_read / redraws / 1e6:.2f} | {64 * lines_read / redraws / vertices:.1f} |")
