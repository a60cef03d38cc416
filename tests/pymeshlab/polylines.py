# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines: as a function of Python and by the example script, with their attributes and errors."""

import numpy
import pymeshlab
from harness import expect_error, meshes, run_script

SCALARS = ("ll_line", "ll_kind", "ll_strength", "ll_slope", "ll_weight", "ll_gradient", "ll_opacity")
FROM_A_PLACE = "Perspective, from the Viewpoint"


def lines_of(ms):
    """Vertices, edges and attributes of the layer that was just made."""
    mesh = ms.current_mesh()
    assert ms.mesh_number() == 2 and mesh.face_number() == 0 and mesh.edge_number() > 100
    attributes = {name: mesh.vertex_custom_scalar_attribute_array(name) for name in SCALARS}
    return mesh.vertex_matrix(), mesh.edge_matrix(), attributes


def create(**parameters):
    ms = meshes()
    view = ms.generate_polyline_from_laplacian_lines(**parameters)
    return (*lines_of(ms), view)


points, edges, attributes, view = create(view=FROM_A_PLACE, viewpoint=[0.5, -2, 3])
assert numpy.allclose(view["viewpoint"], (0.5, -2, 3)) and view["sees_all"]
assert set(attributes["ll_kind"]) <= {0, 1, 2, 3, 4} and 1 in attributes["ll_kind"]
for name in ("ll_weight", "ll_opacity"):
    assert (attributes[name] >= 0).all() and (attributes[name] <= 1).all() and attributes[name].max() > 0
number = attributes["ll_line"]
assert (number[edges[:, 0]] == number[edges[:, 1]]).all(), "an edge joins two lines"
assert set(number) == set(range(int(number.max()) + 1))
for name in ("ll_kind", "ll_strength", "ll_slope"):
    assert all(len(set(attributes[name][number == line])) == 1 for line in set(number)), name

# hidden lines on demand; the default view is from the front, along -z
aside = {"view": FROM_A_PLACE, "viewpoint": [0.5, -3, 1]}
seen, everything = create(**aside), create(**aside, visible_only=False)
assert len(everything[1]) > 1.05 * len(seen[1])
front = create()
assert numpy.allclose(front[3]["view_direction"], (0, 0, 1)) and "viewpoint" not in front[3]
along_z = create(view="Orthographic, along the View Direction", view_direction=[0, 0, 1])
by_script = lines_of(run_script("laplacian_lines_polylines.mlx"))
for other in (along_z, by_script):
    assert (front[0] == other[0]).all() and (front[1] == other[1]).all()
assert numpy.allclose(create(view="Left")[3]["view_direction"], (-1, 0, 0))


def kinds(**parameters):
    return set(create(**aside, **parameters)[2]["ll_kind"])


# by the names of mixtures, from a side where the torus has more than contours
assert kinds(settings="Suggestive Contours") == {1, 7}
assert kinds(settings="Apparent Ridges") == {1, 9}

# the kernel that was computed is what is drawn, and stays
computed = meshes()
computed.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(3))
kernel = computed.current_mesh().vertex_custom_scalar_attribute_array("ll_kernel_size")
computed.generate_polyline_from_laplacian_lines(**aside)
assert len(lines_of(computed)[0]) != len(seen[0]), "the lines are those of the default kernel"
computed.set_current_mesh(0)
assert (computed.current_mesh().vertex_custom_scalar_attribute_array("ll_kernel_size") == kernel).all()

refused = meshes()
make = refused.generate_polyline_from_laplacian_lines
expect_error("There is no window with a current view", make, view=0)
expect_error("The decoration Laplacian Lines has drawn nothing here", make, settings="As the Decoration")
expect_error('"Detail" is 101. It has to be between 0 and 100', make, detail=101)
expect_error("The viewpoint is inside the surface", make, view=FROM_A_PLACE, viewpoint=[1, 0, 0])
assert refused.mesh_number() == 1, "a layer was made in spite of an error"
