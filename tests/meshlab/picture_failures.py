# SPDX-License-Identifier: GPL-3.0-or-later
"""A sheet of ./run --picture is made without the meshes that fail, each of which is named with its reason, and ends
with an error. What MeshLab mends when it opens a mesh is not a failure."""
from harness import *

begin_pictures()


def expect_sheet(drawings, *meshes, said=(), code=1):
    """Of so many drawings in a row."""
    pathlib.Path("sheet.png").unlink(missing_ok=True)
    ended = said_by(take_pictures, "sheet.png", meshes, "--size", "300x200")
    expect(ended == code, f"it ended with {ended} instead of {code}")
    if drawings:
        width = picture_size("sheet.png").split("x")[0]
        expect(int(width) == drawings * 316, f"the sheet is {width} pixels wide")
    else:
        expect(not os.path.exists("sheet.png"), "there is a picture")
    for regex in said:
        expect_text("log", regex)


small_torus()
ply("points.ply", ["0 0 0", "1 0 0", "0 1 0"])
ply("mended.ply", ["0 0 0", "1 0 0", "0 1 0", "2 0 0"], ["3 0 1 2", "3 0 1 1"])
ply("far.ply", ["1e30 0 0", *text_of("torus.ply").split("end_header\n")[1].splitlines()[1:1200]],
    text_of("torus.ply").split("end_header\n")[1].splitlines()[1200:])
pathlib.Path("broken.ply").write_text("not a mesh\n")
pathlib.Path("broken.ply.gz").write_text("not packed\n")
pathlib.Path("crash.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99999999\n")  # has MeshLab read beyond the vertices

expect_sheet(2, "torus.ply", "points.ply", "mended.ply", said=[
    "points.ply: The mesh has no triangle with an area. Laplacian lines need a surface: for a point cloud, reconstruct one first.$",
    "not drawn: points.ply$"])
expect_sheet(1, "broken.ply", "torus.ply", "broken.ply.gz", said=[
    "broken.ply: MeshLab cannot read it: ", "broken.ply.gz cannot be unpacked"])
expect_sheet(2, "torus.ply", "crash.off", "torus.ply", said=[
    "crash.off: MeshLab('s own reader of .off files crashed MeshLab| cannot read it)"])
expect_sheet(1, "far.ply", "torus.ply", said=[
    "far.ply: a few vertices lie so far off that nothing could be seen of the rest; delete them$"])
expect_sheet(0, "points.ply", said=["for a point cloud, reconstruct one first", "no picture was written"])
expect_sheet(2, "torus.ply", "mended.ply", code=0)
