# SPDX-License-Identifier: GPL-3.0-or-later
"""What both halves of the package have: the wheel's, over the core, and that for PyMeshLab, over the plugin."""

import os
import pathlib
import typing

FILTER = "compute_laplacian_lines_per_vertex"
_BESIDE = pathlib.Path(__file__).resolve().parents[1] / "libfilter_laplacian_lines.so"
PLUGIN = pathlib.Path(os.environ.get("LAPLACIAN_LINES_PLUGIN") or _BESIDE)  # for PyMeshLab


class Attribute(typing.NamedTuple):
    """What a field has under a name; some columns of the core's field are in two attributes."""

    name: str
    numbers: int  # a vertex: 3 or 1
    help: str  # on the column
    unit: str  # empty if it has none
    optional: bool  # whether a field may be without it


class Kind(typing.NamedTuple):
    """A kind of lines; its place in KINDS is its number in arrays and in the attribute ll_kind."""

    key: str
    one: str  # "ridge"
    many: str  # "ridges"
    outline: bool  # bounds the form; the others describe what is inside
    color: int  # 0xRRGGBB
    width: float  # in widths of a Laplacian line of full weight


def stored_field(mesh, attributes):
    """What the filter has stored on a mesh of PyMeshLab: arrays by the names of these attributes.

    Raises pymeshlab.PyMeshLabException if one that is not optional is missing.
    """
    from pymeshlab import PyMeshLabException

    arrays = {}
    for attribute in attributes:
        try:
            arrays[attribute.name] = _values(mesh, attribute)
        except PyMeshLabException as error:
            if not attribute.optional:
                raise PyMeshLabException(
                    f"The mesh has no attribute {attribute.name}: run MeshSet.{FILTER}() on it first, again if other "
                    "filters have changed the mesh since.") from error
    return arrays


def _values(mesh, attribute):
    if attribute.numbers == 3:
        return mesh.vertex_custom_point_attribute_matrix(attribute.name)
    return mesh.vertex_custom_scalar_attribute_array(attribute.name)
