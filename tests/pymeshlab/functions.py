# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters as functions of PyMeshLab: parameters and results as Python has them, exceptions that say why and leave the
mesh alone, and the same as by the package for Python. What parameters do is tested by scripts."""

import os
import pathlib
import re

import laplacian_lines
import numpy
import pymeshlab

BUILD = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
MESH = BUILD / "Testing/reference/torus.ply"
WORK = BUILD / "Testing/pymeshlab"
SCALARS = ("ll_line", "ll_kind", "ll_strength", "ll_slope", "ll_weight", "ll_gradient", "ll_opacity")
PLACE = {"view": "Perspective, from the Viewpoint", "viewpoint": [0.5, -2, 3]}
NUMBERS = {kind.key: number for number, kind in enumerate(laplacian_lines.KINDS)}
# Keeps them alive: PyMeshLab 2025.7 crashes when a mesh is loaded after a MeshSet whose filter failed was deleted.
all_sets = []


def numbers(*keys):
    return {NUMBERS[key] for key in keys}


def meshes(path=MESH):
    """A MeshSet with the mesh of this file."""
    all_sets.append(pymeshlab.MeshSet())
    if path:
        all_sets[-1].load_new_mesh(str(path))
    return all_sets[-1]


def stored(mesh):
    """What the filter has left on a mesh, by name."""
    return {row.name: mesh.vertex_custom_point_attribute_matrix(row.name) if row.numbers == 3
            else mesh.vertex_custom_scalar_attribute_array(row.name) for row in laplacian_lines.ATTRIBUTES if not row.optional}


def computed(**given):
    ms = meshes()
    ms.compute_laplacian_lines_per_vertex(**given)
    return stored(ms.current_mesh())


def expect_same(found, expected):
    for name, values in expected.items():
        assert (numpy.float32(found[name]) == values).all(), name


def expect_error(words, function, *arguments, **keywords):
    """Fails unless the call raises one of PyMeshLab's exceptions that says `words`."""
    try:
        function(*arguments, **keywords)
    except (pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException) as error:
        assert words in str(error), f"the exception says: {error}"
    else:
        raise AssertionError(f"nothing was raised; expected: {words}")


def draw(name, ms=None, **given):
    """The file's bytes and what the filter returned."""
    file = WORK / name
    file.unlink(missing_ok=True)
    result = (ms or meshes()).export_laplacian_lines_drawing(file=str(file), **given)
    return file.read_bytes(), result


def polylines(**given):
    """Edges, attributes, and what the filter returned."""
    ms = meshes()
    view = ms.generate_polyline_from_laplacian_lines(**given)
    mesh = ms.current_mesh()
    assert ms.mesh_number() == 2 and mesh.face_number() == 0 and mesh.edge_number() > 100
    return mesh.edge_matrix(), {name: mesh.vertex_custom_scalar_attribute_array(name) for name in SCALARS}, view


WORK.mkdir(parents=True, exist_ok=True)
laplacian_lines.load()
plugins = pymeshlab.plugin_number()
laplacian_lines.load()
assert pymeshlab.plugin_number() == plugins, "loaded twice"

# the field, bit by bit, beside an unchanged mesh
expected = laplacian_lines.field(str(MESH))
assert expected["ll_laplacian_normal"].any()
ms = meshes()
mesh = ms.current_mesh()
before = mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_normal_matrix()
ms.compute_laplacian_lines_per_vertex()
expect_same(stored(mesh), expected)
for was, now in zip(before, (mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_normal_matrix())):
    assert (was == now).all(), "the filter changed the mesh"
ms.compute_laplacian_lines_per_vertex(curvature_derivatives=True)
ms.compute_scalar_by_function_per_vertex(q="ll_curvature_derivative_vvv")  # other filters can use it
derivatives = laplacian_lines.field(str(MESH), curvature_derivatives=True)
assert numpy.allclose(mesh.vertex_scalar_array(), derivatives["ll_curvature_derivative_vvv"])
# lengths and percentages of the diagonal; choices by number and by text
length = mesh.bounding_box().diagonal() / 10
of_share, of_length = (computed(kernel_size=size)["ll_laplacian_normal"]
                       for size in (pymeshlab.PercentageValue(10), pymeshlab.PureValue(length)))
assert (of_share != expected["ll_laplacian_normal"]).any()
assert numpy.allclose(of_length, of_share, rtol=1e-4, atol=1e-4)
cotangent = laplacian_lines.field(str(MESH), laplace_operator="Cotangent")
assert (cotangent["ll_laplacian_normal"] != expected["ll_laplacian_normal"]).any()
expect_same(computed(laplace_operator="Cotangent"), cotangent)
expect_same(computed(laplace_operator=1), cotangent)
for words, given in (('"Kernel Size" is -1. It has to be at least 0', {"kernel_size": pymeshlab.PureValue(-1)}),
                     ("'Heat Kernel (Belkin)'; 'Cotangent'", {"laplace_operator": "Graph"}),
                     ("Parameter kernel not found", {"kernel": 1})):
    expect_error(words, ms.compute_laplacian_lines_per_vertex, **given)
    expect_same(stored(mesh), expected)
expect_error("requires at least one mesh", meshes(None).apply_filter, "compute_laplacian_lines_per_vertex")

# drawings
size = numpy.ptp(before[0], axis=0)
front, result = draw("front.svg")
assert result["scale"] > 1 and numpy.allclose(result["paper"], (210, 297, 0)), result
assert numpy.allclose(result["object"], size, atol=1e-5), result
by_wheel = laplacian_lines.make_drawing(str(MESH)).content
paths = [re.findall(rb' d="[^"]*"', svg) for svg in (front, by_wheel)]
assert paths[0] == paths[1] and len(paths[0]) >= 5, "the wheel draws something else"
assert b"dasharray" in draw("dashed.svg", views="20,60", hidden="Dashed")[0]
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
for words, given in (("does not end in .svg", {"file": str(WORK / "refused.bmp")}), ("not a view", {"views": "above"})):
    expect_error(words, ms.export_laplacian_lines_drawing, **{"file": str(WORK / "refused.svg"), **given})
assert not list(WORK.glob("refused*"))

# polylines with their attributes
edges, attributes, view = polylines(**PLACE)
assert numpy.allclose(view["viewpoint"], PLACE["viewpoint"]) and view["sees_all"]
default_kinds = numbers("laplacian_lines", "contours", "ridges", "borders", "creases")
assert numbers("contours") <= set(attributes["ll_kind"]) <= default_kinds
for name in ("ll_weight", "ll_opacity"):
    assert (attributes[name] >= 0).all() and (attributes[name] <= 1).all() and attributes[name].max() > 0
number = attributes["ll_line"]
assert (number[edges[:, 0]] == number[edges[:, 1]]).all(), "an edge joins two lines"
assert set(number) == set(range(int(number.max()) + 1))
for name in ("ll_kind", "ll_strength", "ll_slope"):
    assert all(len(set(attributes[name][number == line])) == 1 for line in set(number)), name
left = polylines(view="Left")[2]
assert numpy.allclose(left["view_direction"], (-1, 0, 0)) and "viewpoint" not in left
aside = polylines(**PLACE | {"viewpoint": [0.5, -3, 1]}, settings="Suggestive Contours")[1]
assert set(aside["ll_kind"]) == numbers("contours", "suggestive_contours")
ms = meshes()
expect_error('"Detail" is 101. It has to be between 0 and 100', ms.generate_polyline_from_laplacian_lines, detail=101)
assert ms.mesh_number() == 1, "a layer was made in spite of an error"
