# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings as a function of Python and by the example script: files, results, errors; the mesh stays as it is."""

import os
import re

import laplacian_lines
import numpy
import pymeshlab
from harness import EXAMPLES, MESH, expect_error, meshes, work_folder

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
vertices, count = ms.current_mesh().vertex_matrix(), ms.mesh_number()
front, result = draw("front.svg", ms)
assert front.startswith(b"<?xml") and len(paths(front)) >= 5
assert result["scale"] > 1, result
assert numpy.allclose(result["paper"], (210, 297, 0)), result
assert numpy.allclose(result["object"], numpy.ptp(vertices, axis=0), atol=1e-5), result
assert (ms.current_mesh().vertex_matrix() == vertices).all() and ms.mesh_number() == count
assert not ms.current_mesh().has_vertex_color(), "the mesh was changed"

# the same again, by the script, and with the field of the other filter, which is that of the defaults
assert draw("again.svg", ms)[0] == front
ms.compute_laplacian_lines_per_vertex()
assert draw("with_field.svg", ms)[0] == front
oblique, _ = draw("oblique.svg", ms, views="20,60")  # with Laplacian lines, which the field is for
ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(10))
assert draw("smooth.svg", ms, views="20,60")[0] != oblique
script = (EXAMPLES / "laplacian_lines_drawing.mlx").read_text().replace('"drawing.svg"', f'"{WORK / "script.svg"}"')
(WORK / "script.mlx").write_text(script)
ms = meshes()
ms.load_filter_script(str(WORK / "script.mlx"))
ms.apply_filter_script()
assert (WORK / "script.svg").read_bytes() == front

plate, result = draw("plate.dxf", views="six", unit="cm", up="z", paper="a3", scale="2:1", title="Torus")
assert b"POLYLINE" in plate and result["scale"] == 2
assert numpy.allclose(sorted(result["paper"]), (0, 297, 420)), result
assert numpy.allclose(result["object"], 10 * numpy.ptp(vertices, axis=0), atol=1e-4), result
cut, result = draw("cut.svg", views="", sections="z=0.5", furniture=False)
assert 0 < len(paths(cut)) and b"<text" not in cut
assert b"dasharray" not in oblique and b"dasharray" in draw("dashed.svg", views="20,60", hidden="Dashed")[0]

# a layer that was turned and enlarged
ms = meshes()
ms.compute_matrix_from_translation_rotation_scale(rotationy=-90, scalex=2, scaley=2, scalez=2, freeze=False)
turned, result = draw("turned.svg", ms)
assert numpy.allclose(result["object"], 2 * numpy.ptp(vertices, axis=0)[[2, 1, 0]], atol=1e-4), result
left, _ = draw("left.svg", views="left")
assert abs(len(paths(turned)) - len(paths(left))) <= 2, (len(paths(turned)), len(paths(left)))

# all visible layers, of which one hides the other
ms.load_new_mesh(str(MESH))
ms.compute_matrix_from_translation_rotation_scale(translationz=-9, freeze=False)
both, result = draw("both.svg", ms, layers="All Visible Layers", views="front")
assert result["object"][2] > 9, result
dashed, _ = draw("dashed.svg", ms, layers="All Visible Layers", views="front", hidden="Dashed")
assert len(paths(dashed)) > len(paths(both)) and b"stroke-dasharray" in dashed and b"stroke-dasharray" not in both
ms.set_current_mesh_visibility(False)
assert draw("shown.svg", ms, layers="All Visible Layers")[0] == turned
ms.set_current_mesh(0)
ms.set_current_mesh_visibility(False)
expect_error("No visible layer", ms.export_laplacian_lines_drawing, file=str(WORK / "refused.svg"),
             layers="All Visible Layers")

# files are named as in open(), and a name is not cut
by_bytes = os.fsencode(WORK) + b"/caf\xe9.svg"
for name in by_bytes, os.fsdecode(by_bytes), WORK / "ü.svg":
    meshes().export_laplacian_lines_drawing(file=name)
    with open(name, "rb") as file:
        assert file.read() == front, name
    os.unlink(name)
expect_error(r'null\0off.svg" cannot be written: the name holds a null character',
             meshes().export_laplacian_lines_drawing, file=str(WORK / "null\0off.svg"))
assert not list(WORK.glob("null*"))

refused = meshes()
make = refused.export_laplacian_lines_drawing
expect_error("does not end in .svg", make, file=str(WORK / "refused.bmp"))
expect_error("cannot be written", make, file=str(WORK / "missing" / "refused.svg"))
make(file=str(WORK / "made.png"))  # without a QGuiApplication
assert (WORK / "made.png").read_bytes()[:4] == b"\x89PNG"
for words, given in (("not a view", {"views": "above"}), ("There is no window", {"views": "window"}),
                     ("Take the scale", {"scale": "1000:1"}), ("has drawn nothing", {"settings": 1})):
    expect_error(words, make, file=str(WORK / "refused.svg"), **given)
assert not list(WORK.glob("refused*"))

by_name = {parameter.name: parameter for parameter in laplacian_lines.parameters(laplacian_lines.DRAWING_FILTER)}
assert by_name["views"].default == "front" and by_name["views"].type == "str"
assert by_name["paper"].default == "a4" and by_name["file"].default == "drawing.svg"
default = meshes().filter_parameter_values(laplacian_lines.DRAWING_FILTER)["file"]
assert default == str(MESH.with_name("torus_drawing.svg")), default
