#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of rooms in docs/architecture.md hold: every folder of code is a room of theirs, files include what its row
allows and nothing else, of other rooms what is in their include/ alone, none of Qt where the row says "no Qt"; and each
room in the first table has a README.md that says what is in scope and what is not."""

import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
complaints = []


def tables():
    """By heading: the rows of the tables whose first column is "room", as {room: cells}, in their order."""
    found = {}
    for section in re.split(r"(?m)^#+ ", (root / "docs/architecture.md").read_text()):
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("|")]
        if rows and rows[0][0] == "room":
            found[section.splitlines()[0]] = {room: cells for room, *cells in rows[2:]}
    return found


def sources(folder):
    return [file for file in sorted(folder.rglob("*")) if file.suffix in {".h", ".cpp"}]


def includes(file):
    return re.findall(r'^#include "([^"]+)"', file.read_text(), re.M)


def check_folders(folder, rooms):
    """Files of code that no room holds, and rooms that are not there."""
    complaints.extend(f"there is no room {folder / room}" for room in rooms if not (folder / room).is_dir())
    for entry in folder.iterdir():
        complaints.extend(f"{file} is in no room" for file in (() if entry.name.startswith((".", "build")) else sources(entry))
                          if not any(file.is_relative_to(folder / room) for room in rooms))


def owner_of(name, file, rooms, headers):
    """The room that an included header belongs to; None for headers of programs that are not ours."""
    first = name.split("/")[0]
    if first in rooms:
        return first
    own = next(room for room in rooms if file.is_relative_to(root / room))
    return own if name in headers[own] else next((room for room in rooms if name in headers[room]), None)


def check_top(rooms):
    """Between folders, by the second column: all that a room may include besides itself."""
    headers = {}
    for room in rooms:
        files = sources(root / room)
        headers[room] = {str(file.relative_to(base)) for base in (root / room, root / room / "src", root / room / "include")
                         for file in files if file.is_relative_to(base)} | {file.name for file in files}
    count = 0
    for room, (allowed, held) in rooms.items():
        if re.search(r"\bno Qt\b", held):
            complaints.extend(f"{file.relative_to(root)} includes Qt, which its room may not" for file in sources(root / room)
                              if re.search(r"^#include <Q", file.read_text(), re.M))
        allowed = {room, *(word.strip() for word in allowed.split(","))}
        complaints.extend(f"{room} may include {name}, which is not a room" for name in allowed - set(rooms) - {"nothing"})
        for file in sources(root / room):
            for name in includes(file):
                owner = owner_of(name, file, rooms, headers)
                count += owner is not None
                if owner and owner not in allowed:
                    complaints.append(f"{file.relative_to(root)} includes {name} of {owner}, which its room may not")
                elif owner not in {None, room} and (root / owner / "src").is_dir() and not (root / owner / "include" / name).is_file():
                    complaints.append(f"{file.relative_to(root)} includes {name}, which {owner} keeps to itself")
        readme = root / room / "README.md"
        if not readme.is_file() or not re.search("(?s)In scope:.*Out of scope:", readme.read_text()):
            complaints.append(f"{room}/README.md does not say what is in scope and what is out of scope")
    return count


def check_library(library, rooms):
    """Within a library, from a room to itself and those above it in the table, and to public headers."""
    folder = root / library / "src"
    check_folders(folder, rooms)
    allowed, count = {"laplacian_lines", library}, 0
    for room in rooms:
        allowed.add(room)
        for file in sources(folder / room):
            for name in includes(file):
                count += 1
                if name.split("/")[0] not in allowed:
                    complaints.append(f"{file.relative_to(root)} includes {name}: of a later room, or without naming the room")
    return count


found = tables()
top = found.pop("Rooms")
check_folders(root, [*top, "tests", "programs/benchmarks", "docs", "scripts"])
count = check_top(top)
for heading, rooms in found.items():
    count += check_library(heading.removeprefix("Rooms of "), rooms)
print("\n".join(complaints) or f"{count} includes between {len(top) + sum(map(len, found.values()))} rooms")
sys.exit(bool(complaints) or count == 0)
