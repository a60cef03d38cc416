# SPDX-License-Identifier: GPL-3.0-or-later
"""The contour of a sphere is a ring without gaps, from near and far, and as wide as asked, in every render mode; and a
symmetric mesh has a symmetric picture."""
from math import pi

from harness import *

DISTANCES = [2.2 * 10 ** (i / 19) for i in range(20)]  # from a view that is filled to one a tenth as wide
WIDTHS = [1, 2, 3.5, 6, 9]


def rings(name, step=1):
    """From every so many distances."""
    return "".join(f"look {0.6 * d:.5f} {0.64 * d:.5f} {0.48 * d:.5f}  0 0 0\ngrab {name}_{d:.3f}.png\n"
                   for d in DISTANCES[::step])


def widths(name):
    return "".join(f"setdeco Line Width = {width}\ngrab {name}_{width}.png\n" for width in WIDTHS)


sphere()
drive_lines("sphere.ply", f"""size 600x600
setdeco Laplacian Lines = off
setdeco Ridges = off
{rings("fill_ring")}
check Wireframe on
check Fill off
{rings("wireframe_ring", 3)}
check Points on
check Wireframe off
{rings("points_ring", 3)}
check Fill on
check Points off
look 0 0 3  0 0 0  0 1 0
setdeco Contour Width Factor = 1
setdeco Surface = Paper
{widths("fill")}
check Wireframe on
check Fill off
{widths("wireframe")}
""")
for file in sorted(WORK.glob("*_ring_*.png")):  # on every ray from the middle lies ink, or a pixel beside it
    least = convert(file, *only("red", 45), "-morphology", "Dilate", "Square:1", "-distort", "DePolar", "0", "-scale",
                    "x1!",
                    "-format", "%[fx:minima > 0]")
    expect(least == "1", f"the ring in {file.name} has a gap")
for file, width in [(f"{mode}_{width}.png", width) for mode in ("fill", "wireframe") for width in WIDTHS]:
    # ink divided by the length of the ring
    ink = float(convert(file, "-alpha", "off", "-format", "%[fx:(mean.r-mean.g)*w*h]"))
    span = convert(file, "-alpha", "off", "-fuzz", "40%", "-fill", "white", "+opaque", "red", "-format",
                   "%@").split("x")[0]
    measured = ink / ((float(span) - width) * pi)
    expect(abs(measured - width) < 0.5, f"the line in {file} is {measured} pixels wide instead of {width}")
for width in WIDTHS:
    file = f"fill_{width}.png"
    differing = pixels(file, "(", "+clone", "-flop", ")", "-alpha", "off", "-compose", "Difference", "-composite",
                       "-colorspace",
                       "gray", "-threshold", "35%")
    expect(differing <= 150, f"{differing} pixels of {file} differ from its mirror image")
