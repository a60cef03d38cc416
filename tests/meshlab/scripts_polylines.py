# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines in scripts: the example, the files that MeshLab writes of them, and errors."""
from harness import *

EXAMPLE = "laplacian_lines_polylines.mlx"
WARNING = "Warning: the viewpoint"


def lines_of(file, said="", **settings):
    """How many segments there are."""
    accept(file, EXAMPLE, **settings)
    expect_text("log", said)
    return segments_told()


def segments_told():
    return int(re.findall(r"Lines of torus.ply: .* (\d+) segments; ",
                          text_of("log") + "Lines of torus.ply: 0 0 segments; ")[0])


torus()
OUTLINES = "[1-9][0-9]* (occluding contours|outlines)"
visible = lines_of("lines.ply", f"[1-9][0-9]* Laplacian lines, {OUTLINES}, .*; orthographic, "
                   r"along the view direction 0 0 1 \(Front\)")
expect_no_text("log", WARNING)
# MeshLab writes no edges into PLY files, but the vertices
expect_text("lines.ply", "^element vertex [1-9]")
expect_no_text("lines.ply", "^element face [1-9]")
for file, line in (("lines.obj", "^l "), ("lines.dxf", "^ *LINE")):
    if file.endswith(".dxf") and "MESH_SERVER" in os.environ:
        continue  # PyMeshLab writes no .dxf
    accept(file, EXAMPLE)
    expect(len(re.findall(line, text_of(file), re.M)) == visible, f"{file} does not hold {visible} segments")

expect(lines_of("all.ply", visible_only="false") > visible, "hidden lines are left out unasked")
expect_text("log", r"torus\.ply: computed with the default options")
# kinds by mixtures
lines_of("mixture.ply", f"Lines of torus.ply: {OUTLINES}, [0-9]+ suggestive contours, [0-9]+ segments", settings=3)
lines_of("mixture.ply", f"Lines of torus.ply: {OUTLINES}, [0-9]+ apparent ridges, [0-9]+ segments", settings=5)
expect(lines_of("detailed.ply", detail=90) > visible, "more detail gives no more lines")
# the kernel that was computed is what is drawn
filter_script("laplacian_lines.mlx", {"kernel_size": 0.3}, "compute.mlx")
filter_script(EXAMPLE, {})
both = text_of("compute.mlx").replace("</FilterScript>", text_of("script.mlx").split("<FilterScript>")[1])
pathlib.Path("script.mlx").write_text(both)
expect(serve("-i", "torus.ply", "-s", "script.mlx", "-o", "computed.ply") == 0, "computing and drawing failed")
expect_no_text("log", "computed with the default options")
expect(segments_told() not in (0, visible), "the lines are those of the default kernel")
lines_of("side.ply", r"orthographic, along the view direction -1 0 0 \(Left\)", view=5)
lines_of("other.ply", "perspective, from the viewpoint 5 1 1", view=1, viewpoint=(5, 1, 1))
expect_no_text("log", WARNING)
# in the hole of the torus
lines_of("within.ply", WARNING + r" 0 0 0\.1 is within the bounding box of the layer, which reaches from -1\..* to 1\..*\. Take a "
         "viewpoint farther away", view=1, viewpoint=(0, 0, 0.1))

for reason, settings in (
        (r'There is no window with a current view\. Set "View" to 3 \(Front\)', {"view": 0}),
        (r'"View" is 9\. It has to be one of 0 ', {"view": 9}),
        ("The decoration Laplacian Lines has drawn nothing here", {"settings": 1}),
        (r'"Settings" is 10\. It has to be one of 0 ', {"settings": 10}),
        (r'"Detail" is 101\. It has to be between 0 and 100', {"detail": 101}),
        ("is inside the surface", {"view": 1, "viewpoint": (1, 0, 0)}),
        ("is inside the surface", {"view": 1, "viewpoint": (1, 0, 0), "visible_only": "false"}),
        (r'"View Direction" is 0 0 0\. It has to be three finite numbers, not all 0', {"view": 2, "view_direction": (0, 0, 0)})):
    refuse(reason, EXAMPLE, **settings)
