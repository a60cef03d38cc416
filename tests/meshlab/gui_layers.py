# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers in MeshLab's window: lines are those of the mesh as it is after edits, of each layer in its place, also when
layers move, hide, come and go; a mesh that can have no lines says why."""
from harness import *

COMPUTED = r"torus.ply: computed with the default"


def moved(*settings):
    """Gives the current layer a transformation; its coordinates stay."""
    fields = "".join(f"set {setting}\n" for setting in settings)
    return f"trigger Matrix: Set from translation/rotation/scale\nset Freeze Matrix = off\n{fields}apply\nclose\n"


torus()
write_mesh("ring.ply", 120, 60)
ply("points.ply", ["0 0 0", "1 0 0", "0 1 0"])
ply("flat.ply", ["0 0 0", "1 0 0", "2 0 0"], ["3 0 1 2"])
drive(f"""wait
load torus.ply
{SHOW_LINES}setdeco Surface = 1
frame 40 25
grab torus.png
# what is drawn after an edit is what is drawn afresh, and nothing is computed again for that
trigger Laplacian Smooth
set Smoothing steps = 3
apply
close
grab smoothed.png
expect-log (?s){COMPUTED}.*{COMPUTED}
check Laplacian Lines off
draw-lines
grab afresh.png
expect-no-log (?s){COMPUTED}.*{COMPUTED}.*{COMPUTED}
trigger Reload
grab reloaded.png

# a ring that links the torus like the next one of a chain
load ring.ply
{moved("X Translation = 1.1", "X Rotation = 80", "Y Rotation = 20")}
expect-log ring.* came later and has no lines yet
frame 40 25
grab torus_before.png
draw-lines
expect-log Laplacian Lines: ring.* computed
grab both.png
show-layer 0
sleep 200
grab ring.png
show-layer 0
sleep 200
grab both_again.png
setdeco At Rest = 0
wait-for-drawings
grab both_printed.png
show-layer 1
sleep 200
grab torus_printed.png
show-layer 1
sleep 200
setdeco Hidden Lines = 1
grab both_faint.png
setdeco Hidden Lines = 0
setdeco At Rest = 1
select-layer 1
{moved("X Scale = 0")}expect-log Laplacian Lines: ring.*: The layer's transformation cannot be inverted
{moved("X Scale = 1")}
select-layer 0
trigger Delete Current Mesh
grab ring_alone.png
select-layer 1
trigger Delete Current Mesh
load torus.ply
draw-lines
frame 40 25
grab torus_again.png

trigger Delete ALL Faces
apply
close
expect-log Laplacian Lines: torus.ply: The mesh has no triangle with an area.* reconstruct one first
grab nothing.png
trigger Reload
grab torus_whole.png
trigger New Empty Project...
load points.ply
check Laplacian Lines on
expect-log Laplacian Lines: points.ply: The mesh has no triangle with an area
expect-action Laplacian Lines unchecked
load flat.ply
check Laplacian Lines on
expect-log Laplacian Lines: flat.ply: The mesh has no triangle with an area
trigger Close Project
grab torus_left.png
""")
for name in ("smoothed", "ring", "ring_alone", "torus_before"):
    expect(red_pixels(f"{name}.png") > 500, f"{name}.png has no lines")
expect_other_picture("torus.png", "smoothed.png", 1000)
expect_same_picture("smoothed.png", "afresh.png")
for name in ("reloaded", "torus_again", "torus_whole", "torus_left"):
    expect_same_picture("torus.png", f"{name}.png", 100)
expect(red_pixels("torus_before.png") < red_pixels("both.png"), "the second layer has no lines")
expect_other_picture("both.png", "ring.png", 1000)
expect_same_picture("both.png", "both_again.png")
expect_other_picture("both_printed.png", "both.png")
expect(red_pixels("both_printed.png") > red_pixels("torus_printed.png"), "one layer alone is printed")
expect_other_picture("both_printed.png", "both_faint.png")
expect(red_pixels("nothing.png") == 0, "there are lines without faces")
