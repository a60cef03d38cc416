#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""house.py [CHECKOUT]: the size of the project, as a Markdown table: lines of C++, Python, CMake, shell and the
driver's scripts by kind, options that users have, small files and crowded folders."""

import collections
import pathlib
import re
import subprocess
import sys

KINDS = {"tests": "tests", "scripts": "CMake and Python of scripts"}
TOOLS = {"benchmarks", "decoration_settings", "gui_driver", "mesh_noise", "obj_importer"}  # of programs/
MOST_PAIRS, FEW_LINES = 20, 30

root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
names = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, check=True, text=True).stdout
files = [pathlib.PurePath(name) for name in names.split("\0") if name and (root / name).is_file()]


def text_of(file):
    return (root / file).read_text(errors="replace")


def is_bash(file):
    return file.suffix == ".sh" or re.match(r"#!.*\b(ba)?sh\b", text_of(file)[:40]) is not None


def is_code(file):
    return file.suffix in {".cpp", ".h", ".py", ".cmake", ".gui"} or file.name == "CMakeLists.txt" or is_bash(file)


def kind_of(file):
    if file.parts[0] == "programs" and file.parts[1] in TOOLS:
        return "benchmarks and tools"
    return KINDS.get(file.parts[0], "product")


def options():
    """Parameters in docs/parameters.md; words with -- in the usages of the programs and in the table of drawings; and
    all that users have, once each, without developers' ones."""
    text = text_of("docs/parameters.md")
    rows = re.findall(r"^\| (?!parameter|---|\|)(?:\*\*[^*]*\*\* )?([^|]+) \|", text, re.M)
    labels = {label for row in rows for label in row.split(", ")}
    keys = set(re.findall(r"^\| [^|]+ \| `([a-z]+)` \|", text.split("## Export")[-1], re.M)) | {"section"}
    commands = [root / f"scripts/{name}.py" for name in ("product/command", "test", "bench")]
    commands += sorted((root / "programs/drawing_program").glob("*.cpp"))
    words = {(c.parent.name, word) for c in commands for word in re.findall(r"(?<![\w-])--[a-z][a-z-]+", text_of(c))}
    drawn = set(re.findall(r"^\| `--([a-z]+)` \|", text_of("docs/drawing_sheets.md"), re.M))
    words |= {("drawing_program", "--" + word) for word in drawn}
    of_run = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", text_of("scripts/product/command.py")))
    return sum(len(row.split(",")) for row in rows), len(words), len(labels) + len(drawn - keys) + len(of_run)


lines = {file: text_of(file).count("\n") for file in files if is_code(file)}
by_kind = collections.Counter({"all": sum(lines.values())})
for file, count in lines.items():
    by_kind["bash" if is_bash(file) else kind_of(file)] += count
cpp = {file for file in lines if file.suffix in {".cpp", ".h"}}
pairs = collections.Counter(file.parent for file in cpp if file.suffix == ".h" and file.with_suffix(".cpp") in cpp)
crowded = {str(folder): count for folder, count in pairs.items() if count > MOST_PAIRS}
parameters, words, once = options()
rows = [(f"lines: {kind}", by_kind[kind])
        for kind in ("all", "product", "tests", "benchmarks and tools", "CMake and Python of scripts", "bash")]
rows += [
    ("parameters that users have", parameters),
    ("options of the commands", words),
    ("options that users have, once each", once),
    (f"C++ files of {FEW_LINES} lines and less", sum(lines[file] <= FEW_LINES for file in cpp)),
    (f"folders of more than {MOST_PAIRS} pairs", ", ".join(f"{f} {n}" for f, n in sorted(crowded.items())) or "none"),
    ("bash files", sum(map(is_bash, lines))),
    ("README.md, lines", text_of("README.md").count("\n")),
    ("entries at the top level", len({file.parts[0] for file in files if not file.parts[0].startswith(".")})),
]
print("| | |\n|---|--:|\n" + "\n".join(f"| {name} | {value} |" for name, value in rows))
