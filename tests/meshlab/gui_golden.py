# SPDX-License-Identifier: GPL-3.0-or-later
"""Small pictures that were looked at once and found right: a change of the drawing that no other test measures shows
here. After a wanted change, look at the new ones in the build folder's Testing/meshlab/gui_golden and copy them to
golden/."""
from harness import *

if not meshlab_version().startswith("2020."):
    say("skipped: the golden pictures are of MeshLab 2020.09")
    sys.exit(77)
torus()
drive_lines("torus.ply", """setdeco Line Color = #000000
setdeco Contour Color = #000000
size 320x240
setdeco Drawing Style = Publication (Black on White)
look 2.2 1.3 2.2  0 0 0
grab publication.png
setdeco Hidden Lines = Dashed
grab dashed.png
setdeco Hidden Lines = Left Out
setdeco Single Strokes = off
grab paper_form.png
setdeco Single Strokes = on
setdeco Drawing Style = Archaeology (Side Light)
grab archaeology.png
setdeco Drawing Style = Custom
setdeco Surface = Toon
setdeco Background = Paper Color
grab toon.png
""")
for name in ("publication", "dashed", "paper_form", "archaeology", "toon"):
    # blurred by a pixel, since versions of OpenGL differ in the edges of strokes; 0: the same, 1: black on white
    difference = float(convert(f"{name}.png", CHECKOUT / f"tests/meshlab/golden/{name}.png", "-alpha", "off", "-blur",
                               "0x1",
                               "-metric", "RMSE", "-compare", "-format", "%[distortion]"))
    say(f"{name} differs by {difference}")
    expect(difference < 0.015, f"{name}.png differs by {difference} from the golden picture")
