# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines behind the surface are hidden in every render mode, or drawn faint or dashed if the user wants them. Layers
hide each other's lines, also where MeshLab shows no faces; those that are hidden or gone do not, nor do faces that
MeshLab culls."""
from harness import *


def hidden(name):
    """The three ways."""
    return f"""expect-lines
grab {name}_left_out.png
setdeco Hidden Lines = Dashed
expect-other-lines
grab {name}_dashed.png
setdeco Hidden Lines = Faint
grab {name}_faint.png
setdeco Hidden Lines = Left Out
expect-lines
"""


def layers(name):
    """Both, one alone, both again. A layer that has been hidden or shown is noticed by the next redraw, which asks for
    another one."""
    toggle = "show-layer torus\nsleep 200\n"
    return f"grab {name}.png\n{toggle}grab {name}_ring.png\n{toggle}grab {name}_again.png\n"


torus()
write_mesh("ring.ply", 120, 60)
drive_lines("torus.ply", f"""look 2.8 0.2 0.9  0 0 0
{hidden("fill")}
setdeco Surface = Paper
{hidden("paper")}
setdeco Surface = As MeshLab Draws It
check Wireframe on
{hidden("wireframe_on_fill")}
check Fill off
{hidden("wireframe")}
check Points on
check Wireframe off
{hidden("points")}
trigger Toggle Orthographic Camera
{hidden("orthographic_points")}
trigger Toggle Orthographic Camera
check Fill on
check Points off

open ring.ply
select-layer ring
# like the next ring of a chain: each hides a part of the other
{move_layer("X Translation = 0.9", "X Rotation = 80", "Y Rotation = 20")}
check Laplacian Lines on
slot view resetTrackBall
wheel -4
drag 0.4 0.4 0.5 0.5
{layers("both")}
# drawn after the torus, and without faces
select-layer ring
check Fill off
{layers("faceless")}

# of a surface turned inside out, the near faces are culled
trigger New Empty Project...
open torus.ply
size 800x600
{SHOW_LINES}
look 2.8 0.2 0.9  0 0 0
trigger Invert Faces Orientation
set Force Flip = on
apply
close
check Wireframe on
grab wires_on_fill.png
check Fill off
grab wires.png
# an option of faces
check Fill on
check Cull on
grab culled_wires_on_fill.png
check Fill off
grab culled_wires.png
""")


def ink(file):
    """Pixels of nearly pure red."""
    return pixels(f"{file}.png", *only("red", 15))


def pale(file):
    """Those that are anything between white and red. The edges of lines blend with what is below, which has other
    colours in other versions of MeshLab."""
    return pixels(f"{file}.png", "-alpha", "off", "-fuzz", "2%", "-fill", "black", "-opaque", "white", "-fill", "white",
                  "+opaque",
                  "black", "-colorspace", "gray")


seen = ink("fill_left_out")
for mode in ("fill", "paper", "wireframe_on_fill", "wireframe", "points"):  # there are more lines behind than that
    expect_between(0.80 * seen, ink(f"{mode}_left_out"), 1.10 * seen, f"ink in mode {mode}")
    expect_between(0.95 * seen, ink(f"{mode}_dashed"), 2 * seen, f"dashes in mode {mode}")
expect_between(ink("paper_left_out") + 500, ink("paper_dashed"), 100000, "ink with dashes")
expect_between(pale("paper_left_out") + 1000, pale("paper_faint"), 100000, "pixels with faint lines")
expect_between(0, ink("paper_faint"), ink("paper_left_out") + 400, "strong ink with faint lines")

for a, b in [(a + part, b + part) for a,
             b in (("both", "faceless"), ("faceless", "both")) for part in ("", "_ring", "_again")]:
    more = pixels("(", f"{a}.png", *only("red", 35), ")", "(", f"{b}.png", *only("red", 35), "-morphology", "Dilate",
                  "Square:3",
                  "-negate", ")", "-compose", "multiply", "-composite")
    expect(more <= 500, f"{a} has {more} pixels of lines where {b} has none")

unculled, culled = red_pixels("wires_on_fill.png"), red_pixels("culled_wires_on_fill.png")
expect(1000 < unculled < culled / 1.2, f"{culled} pixels of lines with culling, {unculled} without")
expect_between(0.8 * unculled, red_pixels("wires.png"), 1.2 * unculled, "lines without faces")
expect_between(0.8 * culled, red_pixels("culled_wires.png"), 1.2 * culled, "culled lines without faces")
