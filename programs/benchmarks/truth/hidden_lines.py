# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact visible lines of shapes, and their tessellations, by OpenCASCADE."""

import cadquery as cq
import numpy
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepLib import BRepLib
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepTools import BRepTools
from OCP.GCPnts import GCPnts_QuasiUniformDeflection
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.HLRAlgo import HLRAlgo_Projector
from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_REVERSED
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS

POLYGON_DEFLECTION = 0.005  # mm, of the polygons that stand for curves

# (linear, mm; angular, rad), coarse to fine
DEFLECTIONS = [(0.5, 0.6), (0.25, 0.2), (0.1, 0.5), (0.1, 0.3), (0.01, 0.1)]


def shape_of(made):
    return made if isinstance(made, cq.Shape) else made.combine().val() if made.size() > 1 else made.val()


def explored(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def polylines(shape):
    """Of all edges, in the plane of the picture, mm."""
    if shape is None or shape.IsNull():
        return []
    BRepLib.BuildCurves3d_s(shape)
    found = []
    for edge in explored(shape, TopAbs_EDGE):
        curve = BRepAdaptor_Curve(TopoDS.Edge_s(edge))
        points = GCPnts_QuasiUniformDeflection(curve, POLYGON_DEFLECTION)
        if not points.IsDone() or points.NbPoints() < 2:
            raise RuntimeError("a curve of the hidden lines has no points")
        found.append([(p.X(), p.Y()) for p in map(points.Value, range(1, points.NbPoints() + 1))])
    return found


def visible_lines(shape, frame):
    """Those that have to be drawn: sharp edges and outlines; and those that may be: tangent edges and what OpenCASCADE calls
    sewn, edges within one smooth surface, most of them its seam."""
    BRepLib.EncodeRegularity_s(shape.wrapped, 1e-4)  # unions do not know which of their edges are tangent
    right, _, viewer = frame
    algorithm = HLRBRep_Algo()
    algorithm.Add(shape.wrapped, 0)
    axes = gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(*viewer), gp_Dir(*right))
    algorithm.Projector(HLRAlgo_Projector(axes))
    algorithm.Update()
    algorithm.Hide()
    lines = HLRBRep_HLRToShape(algorithm)
    demanded = polylines(lines.VCompound()) + polylines(lines.OutLineVCompound())
    return demanded, polylines(lines.Rg1LineVCompound()) + polylines(lines.RgNLineVCompound())


def tessellation(shape, linear, angular):
    """Vertices and triangles as an STL file has them: single floats, welded where they are equal."""
    BRepTools.Clean_s(shape.wrapped)
    BRepMesh_IncrementalMesh(shape.wrapped, linear, False, angular, False)
    corners = []
    for face in explored(shape.wrapped, TopAbs_FACE):
        place = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(TopoDS.Face_s(face), place)
        if mesh is None:
            raise RuntimeError("a face has no triangles")
        nodes = [mesh.Node(i).Transformed(place.Transformation()) for i in range(1, mesh.NbNodes() + 1)]
        is_reversed = face.Orientation() == TopAbs_REVERSED
        for t in range(1, mesh.NbTriangles() + 1):
            a, b, c = mesh.Triangle(t).Get()
            for node in (a, c, b) if is_reversed else (a, b, c):
                p = nodes[node - 1]
                corners.append((p.X(), p.Y(), p.Z()))
    positions, indices = numpy.unique(numpy.array(corners, "<f4") + 0, axis=0, return_inverse=True)
    triangles = indices.reshape(-1, 3)
    a, b, c = triangles.T
    return positions, triangles[(a != b) & (b != c) & (c != a)].astype("<u4")
