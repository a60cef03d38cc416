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
import typing

import laplacian_lines_columns
import pymeshlab

FILTER = "compute_laplacian_lines_per_vertex"
POLYLINE_FILTER = "generate_polyline_from_laplacian_lines"
PLUGIN = pathlib.Path(__file__).resolve().with_name("libfilter_laplacian_lines.so")


class Attribute(typing.NamedTuple):
    """What the filter stores under a name; some columns of the core's field are in two attributes."""

    name: str
    numbers: int  # a vertex: 3 or 1
    help: str  # on the column
    unit: str  # empty if it has none
    optional: bool  # whether a mesh may be without it


ATTRIBUTES = tuple(Attribute(*row) for row in laplacian_lines_columns.ROWS)


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

    Vectors have the shape (vertices, 3), numbers (vertices,). ATTRIBUTES tells what they are and their
    units; optional ones are in the dictionary if they are on the mesh.
    Raises pymeshlab.PyMeshLabException if the filter has not run on the mesh.
    """
    arrays = {}
    for attribute in ATTRIBUTES:
        try:
            arrays[attribute.name] = _values(mesh, attribute)
        except pymeshlab.PyMeshLabException:
            if not attribute.optional:
                raise
    return arrays


def _values(mesh, attribute):
    if attribute.numbers == 3:
        return mesh.vertex_custom_point_attribute_matrix(attribute.name)
    return mesh.vertex_custom_scalar_attribute_array(attribute.name)
