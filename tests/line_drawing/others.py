# SPDX-License-Identifier: GPL-3.0-or-later
"""others.py PROGRAM: how ezdxf, vpype and svgpathtools read what the program of drawings writes."""

from harness import *
from product.models import bumpy_torus, dragon_file, is_there

python = drawing_tools()
write_cube()
pathlib.Path("torus.ply").write_text(bumpy_torus(160, 80))
plain = ("--strokes", "plain", "--furniture", "none")
for scale in ("1:1", "1:2"):
    for ending in ("svg", "dxf"):
        draw(f"cube_{scale}.{ending}", "--views", "front,left,top", *plain, "--paper", "a2", "--scale", scale,
             "cube.off")
draw("torus.svg", "--views", "front,30,25", *plain, "--paper", "fit", "--scale", "50:1", "torus.ply")
draw("cut.dxf", "--views", "front,top", "--section", "x=0.5", "cube.off")
if is_there(dragon_file("_res2")):  # a scan, once it is fetched
    draw("scan.svg", "--views", "six", *plain, "--unit", "m", dragon_file("_res2"))
print(run([python, "-B", HERE / "read_by_others.py", WORK]))
