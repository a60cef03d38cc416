# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ files can be read, in MeshLab's window and by meshlabserver: with all kinds of indices, colors and materials.
MeshLab 2020.09's own reader ends the program on all of them."""
from harness import *

torus()
lines = [line.split() for line in text_of("torus.ply").split("end_header\n")[1].splitlines()]
vertices = [f"v {' '.join(line)}\n" for line in lines if len(line) == 3]
faces = [f"f {a - len(vertices)} {b + 1}/1 {c + 1}//2\n" for a, b,
         c in (map(int, line[1:]) for line in lines if len(line) == 4)]
pathlib.Path("torus.obj").write_text("".join(vertices + faces))
pathlib.Path("colors.mtl").write_text("newmtl red\nKd 1 0 0\n")
pathlib.Path("colors.obj").write_text("""mtllib colors.mtl
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0 1 1 1
v 2 2 0 1 1 1
vt 0 0
vt 1 1
vn 0 0 1
usemtl red
f 1/1/1 2/1/1 3/2/1 4/2/1
f 2/1/1 5/2/1 3/1/1
f -5/1/1 -4/1/1 5/2/1 3/2/1 4/2/1
""")
if (STAGE / "bin/meshlabserver").exists():
    code = serve("-i", "colors.obj", "-o", "colors.ply", "-m", "vc", "fc")
    expect(code == 0, f"meshlabserver ended with {code}")
    expect_text("colors.ply", "^element vertex 5$")
    expect_text("colors.ply", "^element face 6$")
drive_lines("torus.obj", """expect-lines
trigger Reload
expect-lines
trigger New Empty Project...
open colors.obj
expect-log Opened mesh .*colors.obj
""")

# Only the reader that stands in for MeshLab's: a file whose faces lead nowhere is refused with the reason
for element, reason in () if not meshlab_version().startswith("2020.") else (
        *((f"f 1 2 {index}", "A face refers to a vertex, a normal or a texture") for index in (0, 9, -4)),
        ("l 1 3", "A line refers to a vertex that the file does not have")):
    pathlib.Path("bad.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\n{element}\n" if element[0] == "f"
                                       else f"v 0 0 0\nv 1 0 0\n{element}\n")
    drive_to_failure(f"MeshLab says: Opening Failure: .*bad.obj' {reason}", "wait\nopen bad.obj\nsleep 500")
    code = serve("-i", "bad.obj", "-o", "none.ply")
    expect(code == 255, f"meshlabserver ended with {code}")
    expect_text("log", f"bad.obj: {reason}")
