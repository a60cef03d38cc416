# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as a layer of polylines, from the dialog of the filter: its views, its errors, and where the layer lies."""
from harness import *

OPEN = "trigger Generate Laplacian Lines Polylines\n"
GENERATE = OPEN + "apply\nclose\n"


def refused(reason):
    return f"expect-modal Filter Failure.*{reason}\nbutton OK\n"


torus()
counts = r"Lines of torus.ply: [1-9]\d* Laplacian lines, [1-9]\d* occluding contours, .*[1-9]\d* segments; "
sides = "".join(f"trigger {side}\n{OPEN}apply\nselect-layer 0\nset View = {side}\napply\nclose\nselect-layer 0\n"
                for side in ("Front", "Back", "Left", "Right", "Top", "Bottom"))
drive(rf"""wait
open torus.ply
size 800x600
look 0.5 -2 3  0 0 0
# the view of the window is what the dialog begins with
{GENERATE}
expect-log torus.ply: computed with the default options in
expect-log {counts}perspective, from the viewpoint 0.5 -2 3\n
show-layer torus_laplacian_lines
show-layer torus_laplacian_lines
delete-layer torus_laplacian_lines

{OPEN}
set View = Orthographic, along the View Direction
set View Direction = 1 2 2
set Visible Lines Only = off
apply
expect-log {counts}orthographic, along the view direction 1 2 2\n
select-layer 0
look 3 0 1  0 0 0
set View = Perspective, from the Viewpoint
set Viewpoint = View Pos.
apply
close
expect-log {counts}perspective, from the viewpoint 3 0 1\n
delete-layer torus_laplacian_lines(1)
delete-layer torus_laplacian_lines

# with results of the other filter
select-layer 0
trigger Compute Laplacian Lines
set Laplace Operator = Cotangent
apply
close
slot window updateLayerDialog
{GENERATE}
delete-layer torus_laplacian_lines
expect-no-log (?s)computed with the default.*computed with the default.*computed with the default.*computed with the default

# an orthographic window
trigger Toggle Orthographic Camera
look 0 -3 4  0 0 0
{GENERATE}
expect-log {counts}orthographic, along the view direction -?[\d.e-]+ -0.6 0.8\n

# a layer without faces, and views without lines
{OPEN}
expect-modal PreConditions' Failure.*Generate Laplacian Lines Polylines
button OK
delete-layer torus_laplacian_lines
{OPEN}
set View = Perspective, from the Viewpoint
set Viewpoint = 1 0 0
apply
{refused("The viewpoint is inside the surface")}
set View Direction = 0 0 0
apply
{refused('"View Direction" is 0 0 0, which is not a direction')}
set View Direction = 0 0 1
set View = Orthographic, along the View Direction
set Laplacian Lines = off
set Ridges = off
set Occluding Contours = off
apply
{refused("No lines are seen from there")}
close
expect-log No lines are seen from there, so no layer was created

# sides are those of MeshLab's menu, which is what the dialog begins with
trigger New Empty Project...
open torus.ply
{sides}
log sides.txt

# the current one of several views, and a layer with a transformation: outlines lie around the surface that is seen
trigger New Empty Project...
open torus.ply
check Show Info Panel off
check Show Trackball off
{move_layer("X Scale = 2", "Y Scale = 0.7", "X Translation = 0.3")}
size 800x600
look 3 -3 5  0 0 0
grab surface.png
{GENERATE}
show-layer 0
grab lines.png
show-layer 0
delete-layer torus_laplacian_lines
size 1200x860
trigger Horizontally
view 1
look 1 2 6  0 0 0
view 0
look 6 2 1  0 0 0
{GENERATE}
expect-log perspective, from the viewpoint 6 2 1\n
select-layer 0
view 1
{GENERATE}
expect-log perspective, from the viewpoint 1 2 6\n
""")


def extent(file):
    """Left, top, right and bottom of what is not background."""
    width, height, left, top = map(int, re.findall(r"\d+", convert(
        file, "-alpha", "off", "-bordercolor", "white", "-border", "1", "-fuzz", "4%", "-format", "%@")))
    return left, top, left + width, top + height


surface, lines = extent("surface.png"), extent("lines.png")
expect(all(abs(a - b) <= 4 for a, b in zip(surface, lines)), f"lines end at {lines}, the surface at {surface}")
directions = [[float(f"{float(n):.4f}") for n in line] for line in re.findall(
    r"Lines of .* along the view direction (\S+) (\S+) (\S+)", text_of("sides.txt"))][-12:]
expect(len(directions) == 12 and len({*map(tuple, directions)}) == 6, f"sides.txt tells of {directions}")
for menu, chosen in zip(directions[::2], directions[1::2]):
    expect(menu == chosen, f"MeshLab looks along {menu}, the filter along {chosen}")

# As the decoration draws: nothing before it has, then its lines, its light and its colors, whatever else is set
drive(rf"""wait
open torus.ply
size 800x600
look 0 -2 3  0 0 0
{OPEN}
set Settings = As the Decoration
apply
{refused("The decoration Laplacian Lines has drawn nothing here")}
close
check Laplacian Lines on
setdeco Detail = 80
setdeco Ridge Angle = 25
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
setdeco Hidden Lines = Faint
setdeco Light Position = Fixed to the Camera
setdeco Light Azimuth = 90
setdeco Light Elevation = 0
{OPEN}
set Settings = As the Decoration
set Occluding Contours = off
apply
close
check Show Info Panel off
check Show Trackball off
show-layer 0
grab red.png
show-layer 0
select-layer 0
setdeco Ridge Angle = 10
{OPEN}
set Settings = As the Decoration
apply
set Settings = As Set Below
set Detail = 80
set Visible Lines Only = off
set Light Position = Along the Light Direction
set Light Direction = 1 0 0
select-layer 0
apply
close
log counts.txt
""")
counts = re.findall(r"Lines of torus\.ply: (.* segments); ", text_of("counts.txt"))
expect(len(counts) == 3, f"counts.txt tells of {len(counts)} layers")
expect("occluding contours" in counts[0], f"the decoration draws contours, the filter {counts[0]}")
expect(counts[0] != counts[1], "the decoration's ridge angle does not count")
expect(counts[1] == counts[2], f"as the decoration {counts[1]}, with the same settings {counts[2]}")
# thin lines in their color, without the dots and the gray that MeshLab's edges have by themselves
red, ink = red_pixels("red.png"), pixels("red.png", "-alpha", "off", "-fill", "black", "+opaque", "white", "-negate")
expect(1000 < red == ink < 10000, f"red.png has {red} red pixels, {ink} in all")
