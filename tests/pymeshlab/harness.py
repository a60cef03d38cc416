# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests in PyMeshLab share."""

import os
import pathlib

import laplacian_lines
import numpy
import pymeshlab

BUILD = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
REFERENCE = BUILD / "Testing" / "reference"
WORK = BUILD / "Testing" / "pymeshlab"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "examples"
MESH = REFERENCE / "torus.ply"

# PyMeshLab 2025.7 crashes when a mesh is loaded after a set in which a filter has failed is gone: none goes.
_all_sets = []


def meshes(path=MESH):
    """A MeshSet with the mesh of this file."""
    result = pymeshlab.MeshSet()
    _all_sets.append(result)
    if path:
        result.load_new_mesh(str(path))
    return result


def reference():
    """The core's field of MESH and the truth, both as dictionaries like laplacian_lines.field()."""
    path = REFERENCE / "torus.txt"
    numbers = numpy.loadtxt(path, dtype=numpy.float32)
    computed, truth, first = {}, {}, 0
    with path.open() as file:
        layout = file.readline().split()[1:]
    for name, count in (word.split(":") for word in layout):
        end = first + int(count)
        values = numbers[:, first] if count == "1" else numbers[:, first:end]
        if name.startswith("true_"):
            truth[name[len("true_") :]] = values
        else:
            computed[name] = values
        first = end
    assert first == numbers.shape[1]
    return computed, truth


def largest_difference(a, b):
    """Between two arrays, relative to the largest value of the second; never NaN where that matters."""
    assert a.shape == b.shape, f"{a.shape} instead of {b.shape}"
    assert numpy.isfinite(a).all()
    return numpy.abs(a - b).max() / numpy.abs(b).max()


def expect_same_field(found, expected, tolerance):
    for name, values in expected.items():
        difference = largest_difference(found[name], values)
        assert difference <= tolerance, f"{name} differs by {difference:.3g} of its largest value"


def expect_error(words, function, *arguments, **keywords):
    """Fails unless the call raises one of PyMeshLab's exceptions that says `words`."""
    try:
        function(*arguments, **keywords)
    except (pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException) as error:
        assert words in str(error), f"the exception says: {error}"
    else:
        raise AssertionError(f"nothing was raised; expected: {words}")


def expect_no_field(mesh):
    for name, values in reference()[0].items():
        scalar = values.ndim == 1
        expect_error(name, mesh.vertex_custom_scalar_attribute_array if scalar
                     else mesh.vertex_custom_point_attribute_matrix, name)


def work_folder(name):
    folder = WORK / name
    folder.mkdir(parents=True, exist_ok=True)
    return folder


laplacian_lines.load()
