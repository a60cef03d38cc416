# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing lines leaves no trace in OpenGL's state nor in what MeshLab and other decorations draw, in any render mode;
paper and toon cover what MeshLab draws of a layer, and leave no trace when they are off."""
from harness import *

MODES = {"fill": "", "wireframe_on_fill": "check Wireframe on", "wireframe": "check Fill off",
         "points": "check Points on\ncheck Wireframe off",
         "shader": "check Fill on\ncheck Points off\ntrigger toon.gdp"}
OTHERS = ("Show Box Corners", "Show Normal", "Laplacian Lines Probe")
LINES = ("Laplacian Lines", "Ridges", "Occluding Contours")


def others(state):
    return "".join(f"check {name} {state}\n" for name in OTHERS)


def lines(state):
    return "".join(f"setdeco {name} = {state}\n" for name in LINES)


def traces(name):
    """Without lines; with our decoration on but nothing to draw; with lines; without again. Decorations are drawn in
    the order in which they were switched on: MeshLab's own come after ours here."""
    return f"""grab {name}_plain.png
{others("on")}
grab {name}_others.png
gl-state {name}_others.txt
{others("off")}
check Laplacian Lines on
grab {name}_lines.png
{others("on")}
gl-state {name}_lines_others.txt
{lines("off")}
grab {name}_nothing_others.png
{others("off")}
grab {name}_nothing.png
{lines("on")}
check Laplacian Lines off
grab {name}_after.png
"""


def papers(name):
    """With lines, without lines, in two tones, and as it was before."""
    return f"""check Laplacian Lines on
grab {name}.png
setdeco Surface = Paper
grab {name}_paper.png
{lines("off")}
grab {name}_bare.png
setdeco Surface = Toon
grab {name}_toon.png
{lines("on")}
setdeco Surface = As MeshLab Draws It
grab {name}_again.png
check Laplacian Lines off
"""


torus()
begin = """wait
open torus.ply
size 800x600
check Show Info Panel off
check Show Trackball off
look 2.2 0.8 2.2  0 0 0
check Laplacian Lines on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
setdeco Surface = Toon
setdeco Paper Color = #ffee00
setdeco Tones = 2
setdeco Surface = As MeshLab Draws It
check Laplacian Lines off
"""
drive(begin + "\n".join(f"{commands}\n{traces(mode)}{papers(mode)}" for mode, commands in MODES.items()) + """
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Surface = Paper
expect-lines
trigger Toggle Orthographic Camera
expect-lines
""")


def pixels_other_than(file, *colors):
    edits = [word for color in colors for word in ("-fill", "black", "-opaque", color)]
    return pixels(file, "-alpha", "off", *edits, "-fill", "white", "+opaque", "black", "-colorspace", "gray")


def expect_at_most(most, file, *colors):
    there = pixels_other_than(file, *colors)
    expect(there <= most, f"{file} has {there} pixels that are neither of {colors}, more than {most}")


for mode in MODES:
    expect_same_picture(f"{mode}_plain.png", f"{mode}_nothing.png", 0)
    expect_same_picture(f"{mode}_others.png", f"{mode}_nothing_others.png", 0)
    expect_same_picture(f"{mode}_plain.png", f"{mode}_after.png", 0)
    expect(not same_file(f"{mode}_plain.png", f"{mode}_lines.png"), f"no lines are drawn in mode {mode}")
    expect(same_file(f"{mode}_others.txt", f"{mode}_lines_others.txt"),
           f"the lines change OpenGL's state in mode {mode}")

    expect_same_picture(f"{mode}.png", f"{mode}_again.png", 0)
    # what stands out of the outline is not covered: points are three pixels wide
    outside = {"fill": 0, "shader": 0, "points": 4500}.get(mode, 1500)
    expect_at_most(outside, f"{mode}_bare.png", "white", "#ffee00")
    # but at folds within it: pixels of other colours than paper where fill_bare.png has paper
    specks = pixels("(", f"{mode}_bare.png", "-alpha", "off", "-fill", "black", "-opaque", "#ffee00", "-fill", "white",
                    "+opaque", "black",
                    ")", "(", "fill_bare.png", *only("#ffee00"), ")", "-compose", "Multiply", "-composite",
                    "-colorspace", "gray")
    expect(specks <= 20, f"{mode}_bare.png has specks on the paper")
    # yellow and a shade of it, blended where they meet
    expect_at_most(outside + 6500, f"{mode}_toon.png", "white", "#ffee00", "#968c00")
    expect(pixels_other_than(f"{mode}_toon.png", "white", "#ffee00") > 3000, f"no shade in mode {mode}")
    expect_same_picture("fill_paper.png", f"{mode}_paper.png", 2 * outside)
