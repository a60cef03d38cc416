# SPDX-License-Identifier: GPL-3.0-or-later
"""Scale, With the View: lines of the kernel that suits the zoom come from the background while redraws go on, whatever
is done to the mesh meanwhile, and leave the mesh and no threads behind."""
from harness import *

FAR, MIDDLE, NEAR = "look 0 0 20 0 0 0", "look 0 0 7 0 0 0", "look 1 0 1.2 1 0 0"
OWN = "expect-kernel 0 0"
BEGIN = """wait
open fine.ply
size 800x600
check Show Info Panel off
check Show Trackball off
check Laplacian Lines on
"""

# of diagonal 4.2, 230,400 triangles of mean edge .014: kernels from .028 to .168
write_mesh("fine.ply", 480, 240)
small_torus("small.ply")
between = "".join(f"look 0 0 {distance} 0 0 0\nsleep 400\nredraw\n" for distance in (4, 4.3, 4.6, 5, 5.4, 5.8))
drive(f"""{BEGIN}watch-drawings
redraw
{OWN}
note-threads
# from far away the largest kernel; until it is there, redraws show what there is
{FAR}
setdeco Scale = With the View
together forget-drawings ; redraw ; {OWN} ; redraw ; {OWN} ; expect-true-drawings
await-kernel 0.16 0.17
expect-true-drawings
# zoomed in, finer ones, each between its neighbours in turn; the nearest one stands in
together {NEAR} ; redraw ; expect-kernel 0.1 0.2
await-kernel 0.02 0.04
expect-true-drawings
{MIDDLE}
await-kernel 0.06 0.12
# what was drawn is there at once, as far as it fits into memory: two kernels of this view and one of each before
together {FAR} ; redraw ; expect-kernel 0.16 0.17
{MIDDLE}
wheel 4
expect-true-drawings
wheel -4
expect-true-drawings
# in the middle between two levels both are drawn, and are the core's lines
{between}expect-true-drawings

# a value of the filter is drawn until the user chooses otherwise, and only the kernel is another then
setdeco Scale = As Computed
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 3
apply
close
redraw
{OWN}
expect-true-drawings
{FAR}
setdeco Scale = With the View
await-kernel 0.16 0.17
expect-true-drawings

# edits while a level is computed: what is drawn belongs to the mesh as it is
together {NEAR} ; redraw ; stretch 1.2 ; press-key ; redraw ; {OWN} ; expect-true-drawings
await-kernel 0.02 0.05
expect-true-drawings
# switched off meanwhile, and on again
together {FAR} ; redraw
check Laplacian Lines off
sleep 50
check Laplacian Lines on
redraw
await-kernel 0.16 0.18
expect-true-drawings
# two layers, and one of them goes meanwhile
open small.ply
check Laplacian Lines on
{FAR}
redraw
sleep 300
together {NEAR} ; redraw ; delete-layer 0
expect-true-drawings
sleep 300
# a document is closed meanwhile
trigger New Empty Project...
open fine.ply
check Laplacian Lines on
together {FAR} ; redraw
trigger Close Project
sleep 1000
expect-true-drawings
expect-no-more-threads
""")

# the window is closed meanwhile
drive(f"""{BEGIN}setdeco Scale = With the View
together {FAR} ; redraw
leave
""")

# pictures have the level at once, in all tiles, however soon they are taken
for name in ("first", "second"):
    drive(f"""{BEGIN}size 400x300
{MIDDLE}
setdeco Drawing Style = Publication (Black on White)
together setdeco Scale = With the View ; snapshot {name}.png 2
""")
expect_same_picture("first.png", "second.png", 0)
