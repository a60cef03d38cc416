#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of modules in docs/architecture.md hold: every folder of code is a module of theirs, files include what its row
allows and nothing else, of modules with an include/ what is in it alone, none of Qt where the row says "no Qt"; and each
module in the first table has a README.md that says what is in scope and what is not."""

import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
complaints = []


def tables():
    """By heading: the rows of the tables whose first column is "module", as {module: cells}, in their order."""
    found = {}
    for section in re.split(r"(?m)^#+ ", (root / "docs/architecture.md").read_text()):
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("|")]
        if rows and rows[0][0] == "module":
            found[section.splitlines()[0]] = {module: cells for module, *cells in rows[2:]}
    return found


def sources(place):
    """The files of code in a folder, or the file itself."""
    files = [place] if place.is_file() else sorted(place.rglob("*"))
    return [file for file in files if file.suffix in {".h", ".cpp"}]


def includes(file):
    return re.findall(r'^#include "([^"]+)"', file.read_text(), re.M)


def check_folders(folder, modules):
    """Files of code that no module holds, and modules that are not there."""
    complaints.extend(f"there is no module {folder / module}" for module in modules if not (folder / module).is_dir())
    for entry in folder.iterdir():
        complaints.extend(f"{file} is in no module" for file in (() if entry.name.startswith((".", "build")) else sources(entry))
                          if not any(file.is_relative_to(folder / module) for module in modules))


def owner_of(name, file, modules, headers):
    """The module that an included header belongs to; None for headers of programs that are not ours."""
    first = name.split("/")[0]
    if first in modules:
        return first
    own = next(module for module in modules if file.is_relative_to(root / module))
    return own if name in headers[own] else next((module for module in modules if name in headers[module]), None)


def check_top(modules):
    """Between folders, by the second column: all that a module may include besides itself."""
    headers = {}
    for module in modules:
        files = sources(root / module)
        headers[module] = {str(file.relative_to(base)) for base in (root / module, root / module / "src", root / module / "include")
                         for file in files if file.is_relative_to(base)} | {file.name for file in files}
    count = 0
    for module, (allowed, held) in modules.items():
        if re.search(r"\bno Qt\b", held):
            complaints.extend(f"{file.relative_to(root)} includes Qt, which its module may not" for file in sources(root / module)
                              if re.search(r"^#include <Q", file.read_text(), re.M))
        allowed = {module, *(word.strip() for word in allowed.split(","))}
        complaints.extend(f"{module} may include {name}, which is not a module" for name in allowed - set(modules) - {"nothing"})
        for file in sources(root / module):
            for name in includes(file):
                if name.startswith(".."):
                    complaints.append(f"{file.relative_to(root)} includes {name} by a path")
                owner = owner_of(name, file, modules, headers)
                count += owner is not None
                if owner and owner not in allowed:
                    complaints.append(f"{file.relative_to(root)} includes {name} of {owner}, which its module may not")
                elif owner not in {None, module} and (root / owner / "include").is_dir() and not (root / owner / "include" / name).is_file():
                    complaints.append(f"{file.relative_to(root)} includes {name}, which {owner} keeps to itself")
        readme = root / module / "README.md"
        if not readme.is_file() or not re.search("(?s)In scope:.*Out of scope:", readme.read_text()):
            complaints.append(f"{module}/README.md does not say what is in scope and what is out of scope")
    return count


def check_library(library, modules):
    """Within a library, from a module to itself and those above it in the table, and to public headers."""
    folder = root / library / "src"
    check_folders(folder, modules)
    allowed, count = {"laplacian_lines", library}, 0
    for module in modules:
        allowed.add(module)
        for file in sources(folder / module):
            for name in includes(file):
                count += 1
                if name.split("/")[0] not in allowed:
                    complaints.append(f"{file.relative_to(root)} includes {name}: of a later module, or without naming the module")
    return count


found = tables()
top = found.pop("Modules")
complaints.extend(f"the folders of {module}/src have no table" for module in top
                  if any(map(pathlib.Path.is_dir, root.glob(f"{module}/src/*"))) and f"Modules of {module}" not in found)
check_folders(root, [*top, "tests", "programs/benchmarks", "docs", "scripts"])
count = check_top(top)
for heading, modules in found.items():
    count += check_library(heading.removeprefix("Modules of "), modules)
print("\n".join(complaints) or f"{count} includes of {len(top) + sum(map(len, found.values()))} modules checked")
sys.exit(bool(complaints) or count == 0)
