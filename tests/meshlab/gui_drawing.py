# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings from the dialog of the filter: the window's view, files, errors, and layers that were moved."""
from harness import *

OPEN = "trigger Export Laplacian Lines Drawing\n"


def draw(file, *settings, also="", unit="mm"):
    """The dialog with these settings, applied."""
    fields = "".join(f"set {setting}\n" for setting in settings)
    return f"{OPEN}defaults\nset Unit of the Mesh = {unit}\n{fields}set File = {file}\napply\n{also}close\n"


def refused(reason, more=""):
    return f"expect-modal Filter Failure.*{reason}\nbutton OK\n{more}"


def paths(file):
    """What is drawn, whatever it is called."""
    return re.findall(r' d="([^"]*)"', text_of(file))


def outlines(file):
    return sum(part.split("</g>")[0].count("<path") for part in text_of(file).split('class="outline"')[1:])


def expect_same_lines(a, b):
    """As many, and nine in ten begin within .3 mm of one of the other: cameras are of floats, and faint lines come where
    the mesh's strips meet."""
    starts = [[complex(*map(float, re.findall(r"-?\d*\.?\d+", path)[:2])) for path in paths(file) if path]
              for file in (a, b)]
    count, other = map(len, starts)
    same = sum(min(abs(p - q) for q in starts[1]) < 0.3 for p in starts[0])
    expect(abs(count - other) <= 0.02 * count, f"{a} has {count} lines, {b} {other}")
    expect(same >= 0.9 * count, f"only {same} of {count} lines of {a} and {b} begin at the same places")


RIGHT = """set Views = right
set File = right.svg
apply
"""
TWICE = r"expect-log scale 20:1 on paper of 210 x 297 mm. The object is [45].\S* x [45]" + "\n"
STRETCHED = rf"""expect-log transformation stretches it: its lines are recomputed
expect-log The object is [78]\S* x 2.\S* x
set Settings = As the Decoration
apply
{refused("The decoration Laplacian Lines has drawn nothing here")}"""
MIXED = """set Views = front, window
set File = mixed.svg
apply
expect-log mixed.svg, scale
"""
RING = r"""expect-no-log computed with the default options
expect-log Drawing of torus.ply, ring.ply: \S*both.svg, .* Together the objects are 3
set Layers = Current Layer
set File = ring.svg
apply
expect-log Drawing of ring.ply: \S*ring.svg, .* The object is
"""
torus()
drawn = r"Drawing of torus.ply: /\S*/"
drive(rf"""wait
open torus.ply
size 800x600
look 0 0 6  0 0 0
# the dialog begins with the view of the window and a file beside the mesh
{OPEN}
sleep 300
screen dialog.png
set Unit of the Mesh = mm
apply
expect-log Inner lines have a kernel of √h = [0-9.]* mm on paper
expect-log {drawn}torus_drawing.svg, in perspective and so without a scale on paper of 210 x 297 mm. The object is 2.\S* x 2.\S* x \S* mm in size
set Views = front
set File = front.svg
apply
expect-log {drawn}front.svg, scale 50:1 on paper of 210 x 297 mm
set File = refused.bmp
apply
{refused('"refused.bmp" does not end in .svg, .pdf, .dxf or .png')}
set File = missing/refused.svg
apply
{refused('"missing/refused.svg" cannot be written')}
set File = refused.svg
set Scale = 500:1
apply
{refused("Take the scale 50:1, a larger paper")}
set Scale = 10:1
set Paper = fit
set Views = six, window
set Title = A torus & more
set Unit of the Mesh = cm
set File = plate.pdf
apply
expect-log plate.pdf, scale 10:1 on paper of \S+ x \S+ mm. The object is .* with 10 mm to the unit
close

# an orthographic window
trigger Toggle Orthographic Camera
look 6 0 0  0 0 0
{draw("window.svg", also=RIGHT)}
expect-no-log (?s)in perspective.*in perspective

# layers as they stand: turned, larger, stretched; and as the decoration draws
{draw("left.svg", "Views = left")}
{move_layer("Y Rotation = -90")}
{draw("turned.svg", "Views = front")}
{move_layer("X Scale = 2", "Y Scale = 2", "Z Scale = 2")}
{draw("twice.svg", "Views = front", also=TWICE)}
expect-no-log transformation stretches it
trigger Compute Laplacian Lines
apply
close
{move_layer("X Scale = 3")}
{draw("stretched.svg", "Views = front", also=STRETCHED)}
check Laplacian Lines on
setdeco Detail = 0
setdeco Ridges = off
{draw("as_drawn.svg", "Views = front", "Settings = As the Decoration")}
""")
expect_same_lines("window.svg", "right.svg")
expect_text("torus_drawing.svg", ">perspective, not to scale")
expect_text("front.svg", ">1:|>[0-9.]*:1 ")
expect(open("plate.pdf", "rb").read(5) == b"%PDF-", "plate.pdf is not a PDF")
expect(not os.path.exists("refused.svg") and not os.path.exists("refused.bmp"), "a refused drawing was written")
expect_same_lines("left.svg", "turned.svg")
expect(len(paths("as_drawn.svg")) < len(paths("stretched.svg")), "the decoration's settings do not count")

# A window in perspective: the far face of a cube is to the near one, which hides it, as their distances; an eye within
box("cube.off", 2)
write_mesh("ring.ply", 120, 60)
drive(rf"""wait
open cube.off
size 800x600
look 0 0 6  0 0 0
{draw("cube.svg", "Hidden Lines = Dashed", "Strokes = Plain", also=MIXED)}
look 0 0 0.5  0 0 -1
{draw("refused.svg", also=refused("eye of a view in perspective is inside the surface"))}

# all visible layers, each with its own results; a hidden one is none of them
trigger New Empty Project...
open torus.ply
open ring.ply
select-layer ring
{move_layer("X Translation = 0.9", "X Rotation = 80")}
trigger Compute Laplacian Lines
apply
close
size 800x600
{draw("both.svg", "Views = front, 30,20", "Layers = All Visible Layers", also=RING)}
show-layer torus
sleep 200
{draw("shown.svg", "Views = front, 30,20", "Layers = All Visible Layers")}
show-layer ring
sleep 200
{draw("refused.svg", "Layers = All Visible Layers", also=refused("No visible layer can be drawn"))}
""")
# the upper edges of both faces, the far one's before the near one's
widths = sorted({float(width) for path in paths("cube.svg") for width in re.findall(r"l([0-9.]+) 0", path)})
expect(len(widths) == 2 and abs(widths[0] / widths[1] - 5 / 7) < .002, f"the faces of the cube are {widths} mm wide")
expect_text("mixed.svg", r">View \(perspective, not to scale\)<")
expect(same_file("ring.svg", "shown.svg"), "a hidden layer is drawn")
expect(outlines("both.svg") > outlines("ring.svg"), "one of two layers is not drawn")
expect(not os.path.exists("refused.svg"), "a refused drawing was written")
