# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters of Laplacian lines in PyMeshLab.

    import laplacian_lines, pymeshlab
    laplacian_lines.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh("scan.ply")
    meshes.compute_laplacian_lines_per_vertex()
    field = laplacian_lines.field(meshes.current_mesh())
    meshes.generate_polyline_from_laplacian_lines(viewpoint=[0, 0, 5])

Works with the version of PyMeshLab that the plugin beside this file was built for.
"""

import pathlib

import pymeshlab

FILTER = "compute_laplacian_lines_per_vertex"
POLYLINE_FILTER = "generate_polyline_from_laplacian_lines"
PLUGIN = pathlib.Path(__file__).resolve().with_name("libfilter_laplacian_lines.so")

_POINTS = ("ll_normal", "ll_laplacian_normal", "ll_shape_diagonal", "ll_shape_off_diagonal")
_SCALARS = ("ll_kernel_size",)


def load(plugin=PLUGIN):
    """Loads the plugin and makes its filters methods of MeshSet; loading twice does nothing.

    Raises pymeshlab.PyMeshLabException if PyMeshLab refuses the file.
    """
    if FILTER not in pymeshlab.filter_list():
        pymeshlab.load_plugin(str(plugin))
    # PyMeshLab itself does this only for the plugins that it has at its import.
    for name in (FILTER, POLYLINE_FILTER):
        if not hasattr(pymeshlab.MeshSet, name):
            setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))


def field(mesh):
    """The filter's results on a pymeshlab.Mesh: a dictionary of NumPy arrays by attribute name.

    Vectors have the shape (vertices, 3), ll_kernel_size has (vertices,); units as in the README.
    Raises pymeshlab.PyMeshLabException if the filter has not run on the mesh.
    """
    arrays = {name: mesh.vertex_custom_point_attribute_matrix(name) for name in _POINTS}
    arrays.update((name, mesh.vertex_custom_scalar_attribute_array(name)) for name in _SCALARS)
    return arrays
