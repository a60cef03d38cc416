# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines: as a function of Python and by the example script, with their attributes and errors."""

import pymeshlab

from harness import EXAMPLES, expect_error, meshes

SCALARS = ("ll_line", "ll_kind", "ll_strength", "ll_slope", "ll_weight", "ll_gradient", "ll_opacity")


def lines_of(ms):
    """Vertices, edges and attributes of the layer that was just made."""
    mesh = ms.current_mesh()
    assert ms.mesh_number() == 2 and ms.current_mesh_id() == 1
    assert mesh.face_number() == 0 and mesh.edge_number() > 100
    attributes = {name: mesh.vertex_custom_scalar_attribute_array(name) for name in SCALARS}
    return mesh.vertex_matrix(), mesh.edge_matrix(), attributes


def create(**parameters):
    ms = meshes()
    ms.generate_polyline_from_laplacian_lines(**parameters)
    return lines_of(ms)


def length(points, edges):
    return sum(((points[edges[:, 0]] - points[edges[:, 1]]) ** 2).sum(axis=1) ** 0.5)


parameters = {"view": "Perspective, from the Viewpoint", "viewpoint": [0.5, -2, 3]}
points, edges, attributes = create(**parameters)
assert set(attributes["ll_kind"]) <= {0, 1, 2, 3, 4} and 1 in attributes["ll_kind"]
for name in ("ll_weight", "ll_opacity"):
    assert (attributes[name] >= 0).all() and (attributes[name] <= 1).all() and attributes[name].max() > 0
number = attributes["ll_line"]
assert (number[edges[:, 0]] == number[edges[:, 1]]).all(), "an edge joins two lines"
assert set(number) == set(range(int(number.max()) + 1))
for name in ("ll_kind", "ll_strength", "ll_slope"):
    assert all(len(set(attributes[name][number == line])) == 1 for line in set(number)), name

# hidden lines on demand; the default view is from the front, along -z
from_the_side = {**parameters, "viewpoint": [0.5, -3, 1]}
seen, everything = create(**from_the_side), create(**from_the_side, visible_only=False)
assert length(*everything[:2]) > 1.05 * length(*seen[:2])
front = create()
along_z = create(view="Orthographic, along the View Direction", view_direction=[0, 0, 1])
assert (front[0] == along_z[0]).all() and (front[1] == along_z[1]).all()
assert front[0].shape != points.shape or (front[0] != points).any()

script = meshes()
script.load_filter_script(str(EXAMPLES / "laplacian_lines_polylines.mlx"))
script.apply_filter_script()
by_script = lines_of(script)
assert (by_script[0] == front[0]).all() and (by_script[1] == front[1]).all()

# kinds by the names of mixtures, from a side where the torus has more than contours
def kinds(**parameters):
    return set(create(**from_the_side, **parameters)[2]["ll_kind"])


assert kinds(settings="Suggestive Contours") == {1, 7}
assert kinds(settings="Apparent Ridges") == {1, 9}
assert kinds(settings="Only Laplacian Lines", laplacian_lines=False) == {0, 1}
assert kinds(laplacian_lines=False) == {1}

# the kernel that was computed is what is drawn, and stays
computed = meshes()
computed.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(3))
kernel = computed.current_mesh().vertex_custom_scalar_attribute_array("ll_kernel_size")
computed.generate_polyline_from_laplacian_lines(**from_the_side)
assert len(lines_of(computed)[0]) != len(seen[0]), "the lines are those of the default kernel"
computed.set_current_mesh(0)
assert (computed.current_mesh().vertex_custom_scalar_attribute_array("ll_kernel_size") == kernel).all()

refused = meshes()
make = refused.generate_polyline_from_laplacian_lines
expect_error("There is no window with a current view", make, view=0)
expect_error("The decoration Laplacian Lines has drawn nothing here", make, settings="As the Decoration")
expect_error('"Detail" is 101. It has to be between 0 and 100', make, detail=101)
expect_error("The viewpoint is inside the surface", make, viewpoint=[1, 0, 0])
none = {"laplacian_lines": False, "ridges": False, "borders": False, "contours": False, "creases": False}
expect_error("No lines are seen from there", make, **none)
assert refused.mesh_number() == 1, "a layer was made in spite of an error"

# black unless MeshLab's decoration was asked for other colors
colored = meshes()
colored.generate_polyline_from_laplacian_lines()
assert (colored.current_mesh().vertex_color_matrix() == (0, 0, 0, 1)).all()
