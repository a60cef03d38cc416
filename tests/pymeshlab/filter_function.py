# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter as a function of Python: it gives the core's results, and they are close to the truth."""

import laplacian_lines
import numpy
import pymeshlab
from harness import MESH, expect_error, expect_no_field, expect_same_field, meshes, reference
from harness import largest_difference
from laplacian_lines.shared import stored_field

plugins = pymeshlab.plugin_number()
laplacian_lines.load()
assert pymeshlab.plugin_number() == plugins, "loaded twice"
assert laplacian_lines.FILTER in pymeshlab.filter_list()

computed, truth = reference()
ms = meshes()
mesh = ms.current_mesh()
expect_no_field(mesh)
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
normals = mesh.vertex_normal_matrix()
ms.compute_laplacian_lines_per_vertex()
field = laplacian_lines.field(mesh)

assert field["ll_laplacian_normal"].dtype == numpy.float64
assert field["ll_laplacian_normal"].shape == (mesh.vertex_number(), 3)
assert field["ll_kernel_size"].shape == (mesh.vertex_number(),)
assert set(field) == set(computed), "the module's table is not the core's"
expect_same_field(field, computed, 0)
for name, bound in (("ll_normal", 0.02), ("ll_laplacian_normal", 0.12), ("ll_shape_diagonal", 0.05)):
    error = largest_difference(field[name], truth[name])
    print(f"{name}: {error:.3g} from the truth")
    assert error < bound, "too far"

assert (mesh.vertex_matrix() == vertices).all() and (mesh.face_matrix() == faces).all()
assert (mesh.vertex_normal_matrix() == normals).all(), "the filter changed the mesh's own normals"

# the same by its name; lengths, percentages of the diagonal, choices by number and by text
ms.apply_filter(laplacian_lines.FILTER)
expect_same_field(laplacian_lines.field(mesh), computed, 0)
ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PureValue(0))
expect_same_field(laplacian_lines.field(mesh), computed, 0)

ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(10))
ten_percent = laplacian_lines.field(mesh)
length = mesh.bounding_box().diagonal() / 10
assert numpy.allclose(ten_percent["ll_kernel_size"], length, rtol=1e-6)
ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PureValue(length))
expect_same_field(laplacian_lines.field(mesh), ten_percent, 1e-6)
assert largest_difference(ten_percent["ll_laplacian_normal"], computed["ll_laplacian_normal"]) > 0.01

ms.compute_laplacian_lines_per_vertex(laplace_operator="Cotangent")
cotangent = laplacian_lines.field(mesh)
assert largest_difference(cotangent["ll_laplacian_normal"], computed["ll_laplacian_normal"]) > 0.01
ms.compute_laplacian_lines_per_vertex(laplace_operator=1)
expect_same_field(laplacian_lines.field(mesh), cotangent, 0)

# an optional column may be missing, others may not
for optional in (True, False):
    more = laplacian_lines.Attribute("ll_none", 3 if optional else 1, "nothing", "", optional)
    attributes = (*laplacian_lines.ATTRIBUTES, more)
    if optional:
        assert set(stored_field(mesh, attributes)) == set(computed)
    else:
        expect_error("ll_none", stored_field, mesh, attributes)

# the attributes belong to one mesh; other filters of PyMeshLab can use the scalar one
ms.load_new_mesh(str(MESH))
expect_no_field(ms.current_mesh())
expect_error("ll_normal", laplacian_lines.field, ms.current_mesh())
ms.set_current_mesh(0)
ms.compute_scalar_by_function_per_vertex(q="ll_kernel_size")
assert numpy.allclose(ms.current_mesh().vertex_scalar_array(), cotangent["ll_kernel_size"], rtol=1e-6)
