# SPDX-License-Identifier: GPL-3.0-or-later
"""dask.py PROGRAM: the example of drawings by several machines, with two workers on this one."""

from harness import *

EXAMPLE = CHECKOUT / "docs/examples/draw_with_dask.py"
# -S: as where no packages are installed
said = run([sys.executable, "-S", "-B", EXAMPLE, "plates", "one.ply"], None)
expect("Install it: " in said and "-m pip install dask distributed" in said, f"it is not said what to install: {said}")

python = drawing_tools()
write_cube()
for name in ("one", "two", "three"):
    shutil.copy("cube.ply", f"{name}.ply")
write("bad.ply", "no mesh")
command = [python, "-B", EXAMPLE, "--program", PROGRAM, "plates"]
said = run([*command, "one.ply", "two.ply", "three.ply", "--", "--views", "front,left"])
for name in ("one", "two", "three"):
    expect(os.path.getsize(f"plates/{name}.pdf"), f"{name} has no drawing")
    expect(f"plates/{name}.pdf: drawn\n" in said, f"a worker did not draw {name}: {said}")
expect("0 drawn, 3 unchanged, 0 not drawn\n" in said, f"drawings of workers were made again: {said}")
expect(os.path.getsize("plates/contact_sheet.pdf"), "there is no contact sheet")

said = run([*command, "bad.ply", "one.ply", "--", "--views", "left"], 1)
expect("bad.ply: not drawn: " in said, f"the bad mesh is not reported: {said}")
expect("plates/one.pdf: drawn\n" in said, f"a bad mesh keeps others from being drawn: {said}")
