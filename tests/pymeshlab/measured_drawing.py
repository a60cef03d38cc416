# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings as a function of PyMeshLab and by the example script: files, results, errors; the mesh stays as it is."""

import re

import laplacian_lines
import numpy
import pymeshlab
from harness import MESH, expect_error, meshes, run_script, work_folder

WORK = work_folder("measured_drawing")


def draw(name, ms=None, **given):
    """The file's bytes and what the filter returned."""
    file = WORK / name
    file.unlink(missing_ok=True)
    result = (ms or meshes()).export_laplacian_lines_drawing(file=str(file), **given)
    return file.read_bytes(), result


def paths(svg):
    return re.findall(rb' d="[^"]*"', svg)


ms = meshes()
vertices = ms.current_mesh().vertex_matrix()
size = numpy.ptp(vertices, axis=0)
front, result = draw("front.svg", ms)
assert result["scale"] > 1 and numpy.allclose(result["paper"], (210, 297, 0)), result
assert numpy.allclose(result["object"], size, atol=1e-5), result
assert (ms.current_mesh().vertex_matrix() == vertices).all() and ms.mesh_number() == 1
by_wheel = laplacian_lines.make_drawing(str(MESH)).content
assert paths(front) == paths(by_wheel) and len(paths(front)) >= 5, "the wheel draws something else"

# the same by the script; and with the field of the other filter
run_script("laplacian_lines_drawing.mlx", lambda text: text.replace('"drawing.svg"', f'"{WORK / "script.svg"}"'))
assert (WORK / "script.svg").read_bytes() == front
oblique, _ = draw("oblique.svg", ms, views="20,60")  # with Laplacian lines, which the field is for
ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(10))
assert draw("smooth.svg", ms, views="20,60")[0] != oblique

plate, result = draw("plate.dxf", views="six", unit="cm", up="z", paper="a3", scale="2:1", title="Torus")
assert b"POLYLINE" in plate and result["scale"] == 2 and numpy.allclose(result["object"], 10 * size, atol=1e-4), result
assert b"dasharray" not in oblique and b"dasharray" in draw("dashed.svg", views="20,60", hidden="Dashed")[0]
assert draw("made.png")[0][:4] == b"\x89PNG"  # without a QGuiApplication

# a layer that was turned and enlarged, and all visible layers together
ms = meshes()
ms.compute_matrix_from_translation_rotation_scale(rotationy=-90, scalex=2, scaley=2, scalez=2, freeze=False)
turned, result = draw("turned.svg", ms)
assert numpy.allclose(result["object"], 2 * size[[2, 1, 0]], atol=1e-4), result
ms.load_new_mesh(str(MESH))
ms.compute_matrix_from_translation_rotation_scale(translationz=-9, freeze=False)
assert draw("both.svg", ms, layers="All Visible Layers")[1]["object"][2] > 9
ms.set_current_mesh_visibility(False)
assert draw("shown.svg", ms, layers="All Visible Layers")[0] == turned

make = meshes().export_laplacian_lines_drawing
for words, given in (("does not end in .svg", {"file": str(WORK / "refused.bmp")}),
                     ("cannot be written", {"file": str(WORK / "missing" / "refused.svg")}),
                     ("not a view", {"views": "above"}), ("There is no window", {"views": "window"}),
                     ("Take the scale", {"scale": "1000:1"}), ("has drawn nothing", {"settings": 1})):
    expect_error(words, make, **{"file": str(WORK / "refused.svg"), **given})
assert not list(WORK.glob("refused*"))
