# SPDX-License-Identifier: GPL-3.0-or-later
"""The three filters from their dialogs: results, errors, and a recorded script that does the same to another mesh."""
from harness import *


def refused(reason):
    return f"apply\nexpect-modal Filter Failure.*{reason}\nbutton OK\n"


LINES = r"[1-9]\d* Laplacian lines, .*[1-9]\d* segments; "
DRAWN = r"Drawing of mesh.ply: \S*/"
torus()
torus("mesh.ply")
os.mkdir("scans")
torus("scans/next.ply")
drive(rf"""wait
load torus.ply
trigger Compute Laplacian Lines
apply
expect-log Computed in [\d.]+ s, stored per vertex in ll_normal
close
# attributes are saved with the mesh
trigger Export Mesh...
set-modal V(3f): ll_normal = on
button OK
{SHOW_LINES}expect-no-log torus.ply: computed with the default options
grab computed.png
trigger Compute Laplacian Lines
set Laplace Operator = 1
apply
expect-log Laplace Operator: Cotangent
close
grab cotangent.png

trigger New Empty Project...
load mesh.ply
{SHOW_LINES}frame 40 25
grab before.png
# the view of the window is what the dialogs begin with
trigger Generate Laplacian Lines Polylines
apply
expect-log Lines of mesh.ply: {LINES}perspective, from the viewpoint
close
show-layer 0
sleep 200
grab polylines.png
show-layer 0
select-layer 1
trigger Generate Laplacian Lines Polylines
expect-modal PreConditions' Failure.*Generate Laplacian Lines Polylines
button OK
select-layer 1
trigger Delete Current Mesh
trigger Export Laplacian Lines Drawing
set File = {WORK}/scans/refused.bmp
{refused('does not end in .svg, .pdf, .dxf or .png')}
set File = {WORK}/front.svg
set Views = front
apply
expect-log {DRAWN}front.svg, scale \S+ on paper of 210 x 297 mm
set Scale = 5000:1
{refused("a larger paper")}
close
grab after.png

# a script of both, saved and applied to another mesh, from where the first was seen
trigger New Empty Project...
load torus.ply
trigger Export Laplacian Lines Drawing
apply
close
expect-log Drawing of torus.ply: .*torus_drawing.svg, in perspective
trigger Generate Laplacian Lines Polylines
apply
close
trigger Show current filter script
expect-modal .*
button Save Script
set-modal File name: = {WORK}/recorded.mlx
button Close
trigger New Empty Project...
load scans/next.ply
trigger Show current filter script
button Open Script
set-modal File name: = {WORK}/recorded.mlx
button Apply Script
expect-log Lines of next.ply: {LINES}perspective, from the viewpoint
""")
expect(b"ll_normal" in pathlib.Path("torus.ply").read_bytes(), "no attributes were saved")
expect_other_picture("computed.png", "cotangent.png")
expect(dark_pixels("polylines.png") > 500, "the layer of polylines is not seen")
expect_same_picture("before.png", "after.png")
expect_text("front.svg", "<path")
expect_text("torus_drawing.svg", ">perspective, not to scale")
expect(not os.path.exists("scans/refused.bmp"), "a refused drawing was written")
expect(is_file("scans/next_drawing.svg"), "the script has drawn nothing of the other mesh")
