# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter in PyMeshLab gives the core's field, bit by bit; parameters are those of scripts; what cannot work raises an
exception that says why, and leaves the mesh alone."""

import laplacian_lines
import numpy
import pymeshlab
from harness import MESH, expect_error, meshes, run_script

NAME = "compute_laplacian_lines_per_vertex"


def stored(mesh):
    """What the filter has left on a mesh, by name."""
    return {row.name: mesh.vertex_custom_point_attribute_matrix(row.name) if row.numbers == 3
            else mesh.vertex_custom_scalar_attribute_array(row.name) for row in laplacian_lines.ATTRIBUTES if not row.optional}


def expect_same(found, expected):
    for name, values in expected.items():
        assert (numpy.float32(found[name]) == values).all(), name


def computed(**given):
    ms = meshes()
    ms.apply_filter(NAME, **given)
    return stored(ms.current_mesh())


plugins = pymeshlab.plugin_number()
laplacian_lines.load()
assert pymeshlab.plugin_number() == plugins, "loaded twice"
expected = laplacian_lines.field(str(MESH))
assert expected["ll_laplacian_normal"].any()
ms = meshes()
mesh = ms.current_mesh()
before = mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_normal_matrix()
ms.compute_laplacian_lines_per_vertex()
expect_same(stored(mesh), expected)
for was, now in zip(before, (mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_normal_matrix())):
    assert (was == now).all(), "the filter changed the mesh"
ms.compute_scalar_by_function_per_vertex(q="ll_kernel_size")  # other filters can use it
assert numpy.allclose(mesh.vertex_scalar_array(), expected["ll_kernel_size"])

# lengths and percentages of the diagonal; choices by number and by text; the example script
length = mesh.bounding_box().diagonal() / 10
wide = computed(kernel_size=pymeshlab.PercentageValue(10))
assert numpy.allclose(wide["ll_kernel_size"], length, rtol=1e-6)
assert numpy.allclose(computed(kernel_size=pymeshlab.PureValue(length))["ll_normal"], wide["ll_normal"], atol=1e-6)
cotangent = laplacian_lines.field(str(MESH), laplace_operator="Cotangent")
assert (cotangent["ll_laplacian_normal"] != expected["ll_laplacian_normal"]).any()
expect_same(computed(laplace_operator="Cotangent"), cotangent)
expect_same(computed(laplace_operator=1), cotangent)
expect_same(stored(run_script("laplacian_lines.mlx").current_mesh()), expected)

compute = ms.compute_laplacian_lines_per_vertex
for words, given in (('"Kernel Size" is -1. It has to be at least 0', {"kernel_size": pymeshlab.PureValue(-1)}),
                     ("'Heat Kernel (Belkin)'; 'Cotangent'", {"laplace_operator": "Graph"}),
                     ("Parameter kernel not found", {"kernel": 1})):
    expect_error(words, compute, **given)
    expect_same(stored(mesh), expected)
expect_error("requires at least one mesh", meshes(None).apply_filter, NAME)
flat = meshes(None)
flat.add_mesh(pymeshlab.Mesh(numpy.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), numpy.array([[0, 1, 2]])))
expect_error("The mesh has no triangle with an area", flat.compute_laplacian_lines_per_vertex)
expect_error("ll_normal", stored, flat.current_mesh())
