# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin without the module laplacian_lines: its filters are there by name, and methods on demand."""

import os
import pathlib

import pymeshlab

REFERENCE = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"]) / "Testing" / "reference"
PLUGIN = pathlib.Path(os.environ["PYTHONPATH"]) / "libfilter_laplacian_lines.so"
FILTERS = {"compute_laplacian_lines_per_vertex", "export_laplacian_lines_drawing",
           "generate_polyline_from_laplacian_lines"}

before = set(pymeshlab.filter_list())
pymeshlab.load_plugin(str(PLUGIN))
assert set(pymeshlab.filter_list()) - before == FILTERS

ms = pymeshlab.MeshSet()
ms.load_new_mesh(str(REFERENCE / "torus.ply"))
ms.apply_filter("compute_laplacian_lines_per_vertex", kernel_size=pymeshlab.PercentageValue(2))
by_name = ms.current_mesh().vertex_custom_point_attribute_matrix("ll_laplacian_normal")

for name in FILTERS:
    assert not hasattr(pymeshlab.MeshSet, name), "PyMeshLab makes methods now: say so in the README"
    setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))
ms.compute_laplacian_lines_per_vertex(kernel_size=pymeshlab.PercentageValue(2))
by_method = ms.current_mesh().vertex_custom_point_attribute_matrix("ll_laplacian_normal")
assert (by_name == by_method).all() and by_name.any()
ms.generate_polyline_from_laplacian_lines(viewpoint=[0.5, -2, 3])
assert ms.current_mesh().edge_number() > 100
