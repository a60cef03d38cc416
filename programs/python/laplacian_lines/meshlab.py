# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters in PyMeshLab, of the version that the plugin was built for."""

import pymeshlab

from . import filters
from .drawing import Lines, draw, lines, picture
from .shared import stored_field
from .tables import ATTRIBUTES, DRAWING_FILTER, FILTER, PLUGIN, POLYLINE_FILTER, Parameter, parameters

_FILTERS = (FILTER, POLYLINE_FILTER, DRAWING_FILTER)
SUMMARY = "\n\n".join(filters.summary(name) for name in _FILTERS)


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
    return stored_field(mesh, ATTRIBUTES)
