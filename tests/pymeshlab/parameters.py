# SPDX-License-Identifier: GPL-3.0-or-later
"""What Python users see of the filters: parameters, docstrings and signatures, and points that count when given."""

import contextlib
import inspect
import io
import pydoc
import warnings

import laplacian_lines
import numpy
import pymeshlab
from harness import meshes

FILTERS = (laplacian_lines.FILTER, laplacian_lines.POLYLINE_FILTER, laplacian_lines.DRAWING_FILTER)


def listed_by_pymeshlab(name):
    """The names of the parameters that PyMeshLab has."""
    return set(meshes().filter_parameter_values(name))


for name in FILTERS:
    table = laplacian_lines.parameters(name)
    assert {parameter.name for parameter in table} == listed_by_pymeshlab(name)
    for parameter in table:
        assert parameter.help and parameter.type
        default = meshes().filter_parameter_values(name)[parameter.name]
        if isinstance(parameter.default, (bool, float, int)):
            assert numpy.isclose(default, parameter.default), parameter
    method = getattr(pymeshlab.MeshSet, name)
    assert list(inspect.signature(method).parameters)[1:] == [parameter.name for parameter in table]
    text, module = pydoc.plain(pydoc.render_doc(method)), pydoc.plain(pydoc.render_doc(laplacian_lines))
    for parameter in table:
        assert parameter.name in text and parameter.help.split(":")[0][:40] in text.replace("\n        ", " "), parameter
        assert parameter.name in module
    assert "<b>" not in text and "<br>" not in text
by_name = {parameter.name: parameter for parameter in laplacian_lines.parameters()}
assert by_name["accuracy"].default == 0.001 and by_name["accuracy"].values == "1e-06 to 0.1"
assert by_name["laplace_operator"].default == "Heat Kernel (Belkin)"
meshes().compute_laplacian_lines_per_vertex(**{name: parameter.default for name, parameter in by_name.items()})
assert "= PureValue(0)" in repr(laplacian_lines.parameters()) and "&" not in repr(laplacian_lines.parameters())
assert "1 'Cotangent'" in repr(laplacian_lines.parameters())
try:
    laplacian_lines.parameters("compute")
    raise AssertionError("a filter that there is not has parameters")
except ValueError as error:
    assert laplacian_lines.FILTER in str(error)


def view(**given):
    """What the filter returns, and what is warned of."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = meshes().generate_polyline_from_laplacian_lines(**given)
    return result, [str(warning.message) for warning in caught]


def expect_view(given, direction, viewpoint=None, words=()):
    found, warned = view(**given)
    assert numpy.allclose(found["view_direction"], direction, atol=1e-6), found
    assert ("viewpoint" in found) == (viewpoint is not None), found
    assert viewpoint is None or numpy.allclose(found["viewpoint"], viewpoint), found
    assert len(warned) == len(words) and all(w in text for w, text in zip(words, warned)), warned


# vertices that are not finite have no part in where one looks from
for far in (numpy.inf, -numpy.inf, numpy.nan):
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [far, 0, 0]], dtype=float)
    some = pymeshlab.MeshSet()
    some.add_mesh(pymeshlab.Mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [0, 1, 4]]))
    some.generate_polyline_from_laplacian_lines()

sides = {"Front": (0, 0, 1), "Back": (0, 0, -1), "Left": (-1, 0, 0), "Right": (1, 0, 0), "Top": (0, 1, 0),
         "Bottom": (0, -1, 0)}
expect_view({}, sides["Front"])
for side, direction in sides.items():
    expect_view({"view": side}, direction)
expect_view({"view_direction": [3, 4, 0]}, (0.6, 0.8, 0))
expect_view({"viewpoint": [0, 0, 5]}, (0, 0, 1), (0, 0, 5))
expect_view({"viewpoint": [0, 0, 5], "view": 1}, (0, 0, 1), (0, 0, 5))
expect_view({"viewpoint": [0, 0, 5], "view": "Left"}, sides["Left"], words=["viewpoint has no effect with view='Left'"])
expect_view({"viewpoint": [0, 0, 0.1]}, (0, 0, 1), (0, 0, 0.1), ["Not all of the mesh is in sight"])
lit, at_eye = meshes(), meshes()
lit.generate_polyline_from_laplacian_lines(light_direction=[1, 0, 0])
at_eye.generate_polyline_from_laplacian_lines()
assert lit.current_mesh().edge_number() != at_eye.current_mesh().edge_number(), "light_direction has no effect"
try:
    view(viewpoint=[0, 0, 5], view_direction=[0, 0, 1])
    raise AssertionError("two views at once")
except ValueError as error:
    assert "Give view." in str(error)

# a prompt shows it
with contextlib.redirect_stdout(io.StringIO()) as shown:
    help(pymeshlab.MeshSet.generate_polyline_from_laplacian_lines)
assert "view='Front'" in shown.getvalue()
