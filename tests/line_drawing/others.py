# SPDX-License-Identifier: GPL-3.0-or-later
"""others.py PROGRAM: how ezdxf reads DXF files of a cube of 100 mm."""

from harness import *
from environment.messages import Failure, Unavailable, skip
from environment.python_environments import ensure_python

try:
    python = ensure_python("drawing_tools", 2, "50 MB", "ezdxf==1.4.5")
except (Failure, Unavailable) as reason:
    skip(reason)
write_cube()
for name, *words in (("1", "--scale", "1:1"), (".5", "--scale", "1:2"), ("cut", "--section", "x=0.5")):
    draw(f"{name}.dxf", "--views", "front,left,top", "--paper", "a2", *words, "cube.off")
print(run([python, "-B", "-c", """
import ezdxf, ezdxf.bbox

for name in "1", ".5", "cut":
    document = ezdxf.readfile(f"{name}.dxf")
    errors = document.audit().errors
    assert not errors, [error.message for error in errors]
    assert document.header["$INSUNITS"] == 4, "not in millimetres"
    extents, paper = ezdxf.bbox.extents(document.modelspace()), document.header["$EXTMAX"]
    assert 0 < extents.extmin.x and extents.extmax.x < paper[0], "lines beside the paper"
    assert 0 < extents.extmin.y and extents.extmax.y < paper[1], "lines beside the paper"
    if name == "cut":
        break
    for view in "FRONT", "LEFT", "TOP":
        outline, = document.modelspace().query(f'POLYLINE[layer=="{view}_OUTLINE"]')
        size = ezdxf.bbox.extents([outline]).size
        assert max(abs(side - 100 * float(name)) for side in (size.x, size.y)) < .1, size

used = {entity.dxf.layer for entity in document.modelspace()}
assert used > {"FRONT_OUTLINE", "TOP_OUTLINE", "FRONT_MARKS", "VIEW-4_SECTION", "NAMES", "SCALE", "TITLE"}, used
colors = {}
for name in used:
    colors.setdefault(name.split("_")[-1], set()).add(document.layers.get(name).color)
assert all(len(found) == 1 for found in colors.values()), f"a class in several colors: {colors}"
assert len(set.union(*colors.values())) == len(colors), f"classes of equal colors: {colors}"
"""]))
