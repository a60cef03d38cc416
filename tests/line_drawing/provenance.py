# SPDX-License-Identifier: GPL-3.0-or-later
"""provenance.py PROGRAM VERSION: what a drawing says of its making, and that it can be made again by that."""

import hashlib
import json
import re

from harness import *

VERSION = sys.argv[2]
OPTIONS = ["--views", "front,top", "--section", "x=0.5", "--title", 'A "cube" <&> ü ]]> ' + 30 * "long ", "--unit", "cm"]


def provenance(file):
    data = pathlib.Path(file).read_bytes()
    if file.endswith(".dxf"):
        lines = data.decode("ascii").split("\n")
        expect(all(len(line) <= 255 for line in lines), "R12 has no longer ones")
        data = "".join(lines[i + 1] for i in range(0, len(lines) - 1, 2) if lines[i] == "999").encode()
    return json.loads(re.search(rb'\{"laplacian_lines".*\}', data).group().decode("ascii"))


def expect_same(one, other):
    expect(pathlib.Path(one).read_bytes() == pathlib.Path(other).read_bytes(), f"{one} and {other} differ")


write_cube()
off("other.off", moved(2))
expect(draw("--version") == f"laplacian-lines {VERSION}\n", "the version is another")
made = {"laplacian_lines": VERSION, "options": OPTIONS,
        "meshes": [{"name": "cube.off", "sha256": hashlib.sha256(text_of("cube.off").encode()).hexdigest()}]}
for ending in "svg", "pdf", "dxf", "png":
    old, again = f"old.{ending}", f"again.{ending}"
    draw(old, *OPTIONS, "cube.off")
    expect(provenance(old) == made, f"{old} says {provenance(old)}")
    expect("the file was drawn" not in draw(again, "--like", old, "cube.off"), f"{again} is said to differ")
    expect_same(again, old)

# any letters, and files of any size
for size in range(120, 129):
    write("sized.off", text_of("cube.off") + (size - len(text_of("cube.off")) - 1) % 64 * "\n")
    draw("letters.svg", "--title", "𝄞 \\ / \"\t日本", "sized.off")
    draw("again.svg", "--like", "letters.svg", "sized.off")
    expect_same("again.svg", "letters.svg")
    [mesh] = provenance("again.svg")["meshes"]
    expect(len(text_of("sized.off")) % 64 == size % 64, "the file has another size")
    expect(mesh["sha256"] == hashlib.sha256(text_of("sized.off").encode()).hexdigest(), f"SHA-256 of {size} bytes is wrong")

# what is given besides counts more
draw("larger.svg", "--like", "old.svg", "--unit", "mm", "cube.off")
draw("direct.svg", *OPTIONS, "--unit", "mm", "cube.off")
expect_same("larger.svg", "direct.svg")

# what is not as it was is said
text = text_of("old.svg")
pathlib.Path("earlier.svg").write_text(text.replace(f'"laplacian_lines":"{VERSION}"', '"laplacian_lines":"0.2.9"'))
for sentence, words in (("other.off is not the mesh that the file was drawn from", "old.svg other.off"),
                        ("drawn from 1 meshes; now there are 2", "old.svg cube.off other.off"),
                        (f"drawn by version 0.2.9; this is version {VERSION}", "earlier.svg cube.off")):
    said = draw("now.svg", "--like", *words.split())
    expect(sentence in said, f'nothing says "{sentence}": {said}')

# files that say nothing, or more than a drawing says
refused("does not say how it was drawn", "plate.svg", "--like", "cube.off", "cube.off")
refused("cannot be read", "plate.svg", "--like", "missing.svg", "cube.off")
for value in (100000 * "[", '"cut', '"\\ud834', "{]", "", '"no" "comma"'):
    pathlib.Path("broken.svg").write_text('{"laplacian_lines":' + value)
    refused("does not say how it was drawn", "plate.svg", "--like", "broken.svg", "cube.off")
for change in ('"--like"', '"--"', '"cube.off"'):
    pathlib.Path("changed.svg").write_text(text.replace('"--unit"', change))
    refused("has no options of this command", "plate.svg", "--like", "changed.svg", "cube.off")

# drawings of a folder, and the sheet of them all
draw("plates/", "--format", "svg", "--views", "top", "cube.off", "other.off")
draw("alone.svg", "--views", "top", "cube.off")
expect_same("plates/cube.svg", "alone.svg")
draw("more/", "--format", "svg", "--like", "plates/contact_sheet.svg", "cube.off", "other.off")
for name in "cube", "other", "contact_sheet":
    expect_same(f"more/{name}.svg", f"plates/{name}.svg")
