# SPDX-License-Identifier: GPL-3.0-or-later
"""Line drawings of 3D scans by Laplacian lines (Zhang, He, Seah 2009), from and to NumPy arrays.

    import laplacian_lines
    laplacian_lines.write_drawing("dragon.svg", "dragon.ply", views="six", unit="m")
    seen = laplacian_lines.visible_lines("dragon.ply", direction=(0, 0, 1))

A mesh is a pair of arrays, vertices (n, 3) and faces (m, 3), counter-clockwise seen from outside; a mesh of trimesh, PyVista
or PyMeshLab; or the name of a PLY, STL, OBJ or OFF file. Lengths are in the mesh's unit.

    field(mesh)                        normals, their Laplacian, curvature and kernel at each vertex
    lines(mesh, direction=...)         all lines of a view, in space and on the page
    visible_lines(mesh, direction=...) the parts of them that are seen
    write_drawing(file, mesh, ...)     a measured drawing: views at scale on paper, as SVG, PDF, DXF or PNG
    make_drawing(mesh, ...)            the same, not written
    Surface(mesh)                      a mesh made ready once, for many views: surface.visible_lines(eye=...)

Options are keyword arguments, which help() of each function lists with defaults and limits. What cannot be used raises Error,
a ValueError, or TypeError, and says what can. Computing runs on as many threads as the environment variable
LAPLACIAN_LINES_THREADS says, or on all processors, and other threads of Python go on meanwhile.

In PyMeshLab: where the plugin is, beside this package or as the environment variable LAPLACIAN_LINES_PLUGIN says,
load() brings the filters as methods of MeshSet.
"""

import importlib
import importlib.util
import pkgutil
import typing

# The compiled half may be in an installed wheel, the plugin for PyMeshLab in a build that stands before it in the path.
__path__ = pkgutil.extend_path(__path__, __name__)

from .shared import PLUGIN, Attribute, Kind

_OF_PYMESHLAB = ("DRAWING_FILTER", "FILTER", "Lines", "POLYLINE_FILTER", "Parameter", "draw", "load", "parameters",
                 "picture")
__all__ = ["Attribute", "Kind", "PLUGIN"]

if typing.TYPE_CHECKING or importlib.util.find_spec("._core", __name__):
    from ._core import Error
    from ._core import version as __version__
    from .meshes import as_arrays, read_mesh
    from .polylines import KINDS, Page, Polyline, Polylines
    from .sheets import Drawing, make_drawing, write_drawing
    from .surface import ATTRIBUTES, Surface, field, lines, visible_lines

    __all__ += ["ATTRIBUTES", "Drawing", "Error", "KINDS", "Page", "Polyline", "Polylines", "Surface", "as_arrays", "field",
                "lines", "make_drawing", "read_mesh", "visible_lines", "write_drawing", "__version__"]
else:
    from .meshlab import ATTRIBUTES, field, lines

    __all__ += ["ATTRIBUTES", "field", "lines"]

if PLUGIN.exists() and importlib.util.find_spec("pymeshlab"):
    from .meshlab import DRAWING_FILTER, FILTER, POLYLINE_FILTER, SUMMARY, Lines, Parameter, draw, load, parameters, picture

    __all__ += _OF_PYMESHLAB
    __doc__ = f"{__doc__}\n{SUMMARY}"

if not typing.TYPE_CHECKING:

    def __getattr__(name):
        """What is for PyMeshLab: an error that says what is missing, where it or the plugin is."""
        if name in _OF_PYMESHLAB:
            return getattr(importlib.import_module(".meshlab", __name__), name)
        missing = "" if "Surface" in __all__ else ": the wheel, which has more, is not installed (pip install programs/python)"
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{missing}")
