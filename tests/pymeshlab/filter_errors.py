# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot work raises an exception that says why, and leaves the mesh alone."""

import laplacian_lines
import numpy
import pymeshlab
from harness import expect_error, expect_no_field, expect_same_field, meshes, work_folder

ms = meshes()
mesh = ms.current_mesh()
compute = ms.compute_laplacian_lines_per_vertex

REFUSED = (
    ({"accuracy": 5.0}, '"Accuracy" is 5. It has to be between 1e-06 and 0.1'),
    ({"kernel_size": pymeshlab.PureValue(-1)}, '"Kernel Size" is -1. It has to be at least 0'),
    ({"kernel_size": pymeshlab.PureValue(float("inf"))}, '"Kernel Size" is inf'),
    ({"kernel_size": 0.1}, "kernel_size"),
    ({"laplace_operator": "Graph"}, "'Heat Kernel (Belkin)'; 'Cotangent'"),
    ({"laplace_operator": 2}, "Enum 2 not valid"),
    ({"kernel": 1}, "Parameter kernel not found"),
)


def expect_refusals():
    for parameters, words in REFUSED:
        expect_error(words, compute, **parameters)


vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
expect_refusals()
expect_no_field(mesh)
expect_error("run MeshSet.compute_laplacian_lines_per_vertex() on it first", laplacian_lines.field, mesh)

# what an earlier run has stored survives a failed one
compute()
before = laplacian_lines.field(mesh)
expect_refusals()
expect_same_field(laplacian_lines.field(mesh), before, 0)
assert (mesh.vertex_matrix() == vertices).all() and (mesh.face_matrix() == faces).all()

expect_error("requires at least one mesh", meshes(None).apply_filter, laplacian_lines.FILTER)

points = meshes(None)
points.add_mesh(pymeshlab.Mesh(numpy.eye(3)))
expect_error("does not have Any Faces", points.compute_laplacian_lines_per_vertex)
expect_no_field(points.current_mesh())

flat = meshes(None)
flat.add_mesh(pymeshlab.Mesh(numpy.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), numpy.array([[0, 1, 2]])))
expect_error("The mesh has no triangle with an area", flat.compute_laplacian_lines_per_vertex)
expect_no_field(flat.current_mesh())

corners = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]])
sides = numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [1, 2, 4]])
for far in (1e30, 1e300):
    corners[4, 0] = far
    spiked = meshes(None)
    spiked.add_mesh(pymeshlab.Mesh(corners, sides))
    expect_error("vertices lie far off", spiked.generate_polyline_from_laplacian_lines)
    assert spiked.mesh_number() == 1

expect_error("already loaded", pymeshlab.load_plugin, str(laplacian_lines.PLUGIN))
other = work_folder("errors") / "libfilter_other.so"
other.write_text("not a library")
expect_error("does not seem to be a Qt Plugin", pymeshlab.load_plugin, str(other))
