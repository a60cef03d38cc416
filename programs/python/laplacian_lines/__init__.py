# SPDX-License-Identifier: GPL-3.0-or-later
"""Line drawings of 3D scans by Laplacian lines (Zhang, He, Xie, Chen 2009), from and to NumPy arrays.

    import laplacian_lines
    laplacian_lines.write_drawing("dragon.svg", "dragon.ply", views="six", unit="m")
    seen = laplacian_lines.visible_lines("dragon.ply", direction=(0, 0, 1))

A mesh is a pair of arrays, vertices (n, 3) and faces (m, 3), counter-clockwise seen from outside; a mesh of trimesh, PyVista
or PyMeshLab; or the name of a PLY, STL, OBJ or OFF file. Lengths are in the mesh's unit.

    field(mesh)                        normals, their Laplacian, curvature and kernel at each vertex
    lines(mesh, direction=...)         all lines of a view, in space and on the page
    visible_lines(mesh, direction=...) the parts of them that are seen
    strokes(mesh, direction=...)       the strokes of a drawing of the view, in space
    write_drawing(file, mesh, ...)     a measured drawing: views at scale on paper, as SVG, PDF, DXF or PNG
    make_drawing(mesh, ...)            the same, not written
    Surface(mesh)                      a mesh prepared once, for many views: surface.visible_lines(eye=...)

Options are keyword arguments, which help() of each function lists with defaults and limits. What cannot be used raises Error,
a ValueError, or TypeError, and says what can. Computing runs on as many threads as the environment variable
LAPLACIAN_LINES_THREADS says, or on all processors, and other threads of Python go on meanwhile.

load() brings the filters to PyMeshLab, where ./run --python has built the plugin.
"""

from ._core import Error
from ._core import version as __version__
from .meshes import as_arrays, read_mesh
from .meshlab import load
from .polylines import KINDS, Kind, Page, Polyline, Polylines
from .sheets import Drawing, make_drawing, write_drawing
from .surface import ATTRIBUTES, Attribute, Surface, field, lines, strokes, visible_lines

__all__ = ["ATTRIBUTES", "Attribute", "Drawing", "Error", "KINDS", "Kind", "Page", "Polyline", "Polylines", "Surface",
           "__version__", "as_arrays", "field", "lines", "load", "make_drawing", "read_mesh", "strokes", "visible_lines",
           "write_drawing"]
