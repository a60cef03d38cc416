# SPDX-License-Identifier: GPL-3.0-or-later
"""The field that the filter has stored on a mesh of PyMeshLab."""

import pymeshlab

FILTER = "compute_laplacian_lines_per_vertex"


def stored_field(mesh, attributes):
    """Arrays by the names of these attributes. Raises pymeshlab.PyMeshLabException if one that is not optional is missing."""
    arrays = {}
    for attribute in attributes:
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
