#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""provenance.py PROGRAM VERSION: what a drawing says of its making, and that it can be made again by that."""
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM, VERSION = os.path.abspath(sys.argv[1]), sys.argv[2]
CUBE = """OFF
8 6 0
0 0 0
10 0 0
0 10 0
10 10 0
0 0 10
10 0 10
0 10 10
10 10 10
4 0 2 3 1
4 4 5 7 6
4 0 1 5 4
4 2 6 7 3
4 0 4 6 2
4 1 3 7 5
"""
OPTIONS = ["--views", "front,top", "--section", "x=0.5", "--title", 'A "cube" <&> ü ]]> ' + 30 * "long ", "--unit", "cm"]


def run(*words):
    result = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
    return result.returncode, result.stdout, result.stderr


def draw(*words):
    code, _, said = run(*words)
    assert code == 0, said
    return said


def refused(reason, *words):
    code, _, said = run(*words)
    assert code == 1 and reason in said, (code, said)
    assert not pathlib.Path(words[0]).exists()


def provenance(file):
    data = pathlib.Path(file).read_bytes()
    if file.endswith(".dxf"):
        lines = data.decode("ascii").split("\n")
        assert all(len(line) <= 255 for line in lines), "R12 has no longer ones"
        data = "".join(lines[i + 1] for i in range(0, len(lines) - 1, 2) if lines[i] == "999").encode()
    return json.loads(re.search(rb'\{"laplacian_lines".*\}', data).group().decode("ascii"))


os.chdir(tempfile.mkdtemp())
pathlib.Path("cube.off").write_text(CUBE)
pathlib.Path("other.off").write_text(CUBE.replace("10", "20"))
assert run("--version") == (0, f"laplacian-lines {VERSION}\n", "")

expected = {"laplacian_lines": VERSION,
            "meshes": [{"name": "cube.off", "sha256": hashlib.sha256(CUBE.encode()).hexdigest()}],
            "options": OPTIONS}
for ending in "svg", "pdf", "dxf":
    old, again = f"old.{ending}", f"again.{ending}"
    said = draw(old, *OPTIONS, "cube.off")
    assert provenance(old) == expected, provenance(old)
    assert draw(again, "--like", old, "cube.off") == said
    assert pathlib.Path(old).read_bytes() == pathlib.Path(again).read_bytes(), f"{ending} is not drawn again"
draw("from_pdf.svg", "--like", "old.pdf", "cube.off")
assert pathlib.Path("from_pdf.svg").read_bytes() == pathlib.Path("old.svg").read_bytes()

# what is given besides counts more
draw("larger.svg", "--like", "old.svg", "--unit", "mm", "cube.off")
assert provenance("larger.svg")["options"] == OPTIONS + ["--unit", "mm"]
draw("direct.svg", *OPTIONS, "--unit", "mm", "cube.off")
assert pathlib.Path("direct.svg").read_bytes() == pathlib.Path("larger.svg").read_bytes()

# what is not as it was is said
assert "other.off is not the mesh that the file was drawn from" in draw("other.svg", "--like", "old.svg", "other.off")
assert "drawn from 1 meshes; now there are 2" in draw("two.svg", "--like", "old.svg", "cube.off", "other.off")
text = pathlib.Path("old.svg").read_text()
pathlib.Path("earlier.svg").write_text(text.replace(f'"laplacian_lines":"{VERSION}"', '"laplacian_lines":"0.2.9"'))
assert "drawn by version 0.2.9; this is version " + VERSION in draw("now.svg", "--like", "earlier.svg", "cube.off")

# files that say nothing, or more than a drawing says
refused("does not say how it was drawn", "none.svg", "--like", "cube.off", "cube.off")
refused("cannot be read", "none.svg", "--like", "missing.svg", "cube.off")
for change in ('"--contact-view"', '"--like"', '"--"', '"cube.off"'):
    pathlib.Path("changed.svg").write_text(text.replace('"--unit"', change))
    refused("has no options of this command", "none.svg", "--like", "changed.svg", "cube.off")
pathlib.Path("changed.svg").write_text(re.sub(r',"options":\[.*\](?=})', "", text))
refused("has no options of this command", "none.svg", "--like", "changed.svg", "cube.off")

# drawings of a collection, with and without a sheet of them all
draw("plates/", "--format", "svg", "--views", "top", "cube.off", "other.off")
draw("alone.svg", "--views", "top", "cube.off")
assert pathlib.Path("plates/cube.svg").read_bytes() == pathlib.Path("alone.svg").read_bytes()
assert [m["name"] for m in provenance("plates/contact_sheet.svg")["meshes"]] == ["cube.off", "other.off"]
draw("more/", "--format", "svg", "--like", "plates/contact_sheet.svg", "cube.off", "other.off")
for name in "cube", "other", "contact_sheet":
    assert pathlib.Path(f"more/{name}.svg").read_bytes() == pathlib.Path(f"plates/{name}.svg").read_bytes()
