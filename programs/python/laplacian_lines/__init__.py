# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters of Laplacian lines in PyMeshLab, and drawings of their lines.

    import laplacian_lines, pymeshlab
    laplacian_lines.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh("scan.ply")

    meshes.compute_laplacian_lines_per_vertex()
    field = laplacian_lines.field(meshes.current_mesh())

    view = meshes.generate_polyline_from_laplacian_lines(view="Front")
    laplacian_lines.picture("lines.png", meshes.current_mesh(), view)

    meshes.set_current_mesh(0)
    meshes.export_laplacian_lines_drawing(file="plate.svg", views="six", unit="m")

Without Matplotlib, all but picture() and draw() works. parameters(FILTER), parameters(POLYLINE_FILTER) and
parameters(DRAWING_FILTER) list what the filters take. Works with the version of PyMeshLab that the plugin beside this
package was built for.
"""

import pymeshlab

from . import filters, tables
from .drawing import Lines, draw, lines, picture
from .tables import ATTRIBUTES, DRAWING_FILTER, FILTER, PLUGIN, POLYLINE_FILTER, Attribute, Parameter, parameters

__all__ = ["ATTRIBUTES", "DRAWING_FILTER", "FILTER", "PLUGIN", "POLYLINE_FILTER", "Attribute", "Lines", "Parameter",
           "draw", "field", "lines", "load", "parameters", "picture"]
_FILTERS = (FILTER, POLYLINE_FILTER, DRAWING_FILTER)
__doc__ += "\n" + "\n\n".join(filters.summary(name) for name in _FILTERS)


def load(plugin=PLUGIN):
    """Loads the plugin and makes its filters methods of MeshSet; loading twice does nothing.

    Raises pymeshlab.PyMeshLabException if PyMeshLab refuses the file.
    """
    if FILTER not in pymeshlab.filter_list():
        pymeshlab.load_plugin(str(plugin))
    # PyMeshLab itself does this only for the plugins that it has at its import.
    for name in _FILTERS:
        if not hasattr(pymeshlab.MeshSet, name):
            setattr(pymeshlab.MeshSet, name, filters.method(name))


def field(mesh):
    """The filter's results on a pymeshlab.Mesh: a dictionary of NumPy arrays by attribute name.

    Vectors have the shape (vertices, 3), numbers (vertices,). ATTRIBUTES tells what they are and their
    units; optional ones are in the dictionary if they are on the mesh.
    Raises pymeshlab.PyMeshLabException, which names the filter, if it has not run on the mesh.
    """
    arrays = {}
    for attribute in ATTRIBUTES:
        try:
            arrays[attribute.name] = _values(mesh, attribute)
        except pymeshlab.PyMeshLabException as error:
            if not attribute.optional:
                raise pymeshlab.PyMeshLabException(
                    f"The mesh has no attribute {attribute.name}: run MeshSet.{FILTER}() on it first, again if other "
                    "filters have changed the mesh since.") from error
    return arrays


def _values(mesh, attribute):
    if attribute.numbers == 3:
        return mesh.vertex_custom_point_attribute_matrix(attribute.name)
    return mesh.vertex_custom_scalar_attribute_array(attribute.name)
