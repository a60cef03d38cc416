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
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
MESH = REFERENCE / "torus.ply"

ATTRIBUTES = ("ll_normal", "ll_laplacian_normal", "ll_shape_diagonal", "ll_shape_off_diagonal")

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
    columns = numpy.loadtxt(REFERENCE / "torus.txt", dtype=numpy.float32)
    computed = {name: columns[:, 3 * i : 3 * i + 3] for i, name in enumerate(ATTRIBUTES)}
    computed["ll_kernel_size"] = columns[:, 12]
    truth = {name: columns[:, 13 + 3 * i : 16 + 3 * i] for i, name in enumerate(ATTRIBUTES)}
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
    for name in ATTRIBUTES:
        expect_error(name, mesh.vertex_custom_point_attribute_matrix, name)
    expect_error("ll_kernel_size", mesh.vertex_custom_scalar_attribute_array, "ll_kernel_size")


def work_folder(name):
    folder = WORK / name
    folder.mkdir(parents=True, exist_ok=True)
    return folder


laplacian_lines.load()
