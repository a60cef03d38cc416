# SPDX-License-Identifier: GPL-3.0-or-later
"""One choice makes a drawing in black on white, whatever else is set, in any render mode and with several layers;
taking it back leaves the view as it was."""
from harness import *

PUBLICATION = "setdeco Drawing Style = Publication (Black on White)\n"
AS_SET_BELOW = "setdeco Drawing Style = Custom\n"


def styles(name):
    """As it was, the drawing, and as it was again."""
    return f"grab {name}.png\n{PUBLICATION}grab {name}_publication.png\n{AS_SET_BELOW}grab {name}_again.png\n"


set_background(("Bot", 40, 0, 80), ("Top", 0, 90, 20))
torus()
write_mesh("ring.ply", 120, 60)
drive_lines("torus.ply", f"""look 2.2 0.8 2.2  0 0 0
setdeco Paper Color = #ffee00
{styles("fill")}
gl-state before.txt
{PUBLICATION}
gl-state drawing.txt
{AS_SET_BELOW}
check Wireframe on
{styles("wireframe_on_fill")}
check Fill off
{styles("wireframe")}
check Points on
check Wireframe off
{styles("points")}
check Fill on
check Points off
trigger Toggle Orthographic Camera
{styles("orthographic")}
trigger Toggle Orthographic Camera

# nothing of the drawing is left out when there are no lines
setdeco Laplacian Lines = off
setdeco Ridges = off
setdeco Occluding Contours = off
{PUBLICATION}
grab bare.png
setdeco Laplacian Lines = on
setdeco Ridges = on
setdeco Occluding Contours = on
grab by_style.png
snapshot tiled.png 2
snapshot transparent.png 1 transparent
{AS_SET_BELOW}

# the same by hand, with a background of one's own
setdeco Surface = Paper
setdeco Background = Paper Color
grab yellow.png
setdeco Paper Color = #ffffff
setdeco Line Color = #000000
setdeco Contour Color = #000000
grab by_hand.png
setdeco Background = As MeshLab Draws It
setdeco Surface = As MeshLab Draws It
setdeco Paper Color = #ffee00

# the lines are the core's, and for archaeologists those of a light on the upper left
ink #000000
{PUBLICATION}
expect-lines
setdeco Drawing Style = Archaeology (Side Light)
expect-lines light_x=-0.5 light_y=0.5 light_z=0.70711
expect-other-lines
grab archaeology.png
setdeco Light Azimuth = 90
expect-other-lines light_x=-0.5 light_y=0.5 light_z=0.70711
setdeco Light Azimuth = 315
{AS_SET_BELOW}

# a second layer erases nothing of the first
open ring.ply
select-layer ring
{move_layer("X Translation = 1.1", "X Rotation = 80", "X Scale = 0.8", "Y Scale = 0.8", "Z Scale = 0.8")}
check Laplacian Lines on
check Laplacian Lines Probe on
slot view resetTrackBall
{styles("two_layers")}
{PUBLICATION}
expect-lines
""")


def corner(file):
    return convert(file, "-format", "%[hex:u.p{9,9}]").lower()


def colors(file):
    """How many pixels have a colour of their own."""
    return pixels(file, "-alpha", "off", "-colorspace", "HSL", "-channel", "G", "-separate", "-threshold", "1%")


def expect_drawing(file):
    """Grey strokes on pure white, of which there is much."""
    expect(colors(file) == 0, f"{colors(file)} pixels of {file} are not grey")
    white = float(convert(file, "-alpha", "off", "-fill", "black", "+opaque", "white", "-format", "%[fx:mean]"))
    expect(0.8 < white < 0.995 and corner(file) == "ffffff",
           f"{white} of {file} is white, its corner is {corner(file)}")


for view in ("fill", "wireframe_on_fill", "wireframe", "points", "orthographic", "two_layers"):
    expect_same_picture(f"{view}.png", f"{view}_again.png", 0)
    if view != "points":
        expect_drawing(f"{view}_publication.png")
        expect(colors(f"{view}.png") > 200000, f"{view}.png has little colour to be taken away")
expect(same_file("before.txt", "drawing.txt"), "the drawing changes OpenGL's state")
expect_drawing("tiled.png")
expect_drawing("archaeology.png")
# points stand out of the outline
expect(corner("points_publication.png") == "ffffff", "the corner of points_publication.png is not white")
expect(colors("points_publication.png") < 4500, "too many pixels among points are not grey")
expect(corner("yellow.png") == "ffee00", "the corner of yellow.png is not yellow")
expect_same_picture("by_style.png", "by_hand.png", 0)
# paper around the form does not fill a snapshot that is to have no background; paper on it stays
alpha = convert("transparent.png", "-alpha", "extract", "-format",
                "%[fx:u.p{9,9}] %[fx:maxima] %[fx:mean > 0.1 && mean < 0.4]")
expect(alpha == "0 1 1", f"transparent.png has alpha {alpha} at the corner, at most, and in the middle")
expect(pixels("bare.png", "-alpha", "off", "-fill", "black", "-opaque", "white", "-fill", "white", "+opaque",
              "black") == 0,
       "bare.png is not white all over")
