# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as arrays, whichever package they are of; none of these packages is needed."""

from __future__ import annotations

import os
import pathlib
import warnings
from typing import Any

import numpy
from numpy.typing import NDArray

from . import _core

Arrays = tuple[NDArray[numpy.float64], NDArray[numpy.uint32]]


def read_mesh(file: str | os.PathLike[str]) -> Arrays:
    """The mesh in a PLY, STL, OBJ or OFF file.

    Returns vertices, (n, 3), in the unit of the file, and faces, (m, 3), numbers of vertices; polygons are triangles
    then. Raises OSError if the file cannot be read, Error if it is of another kind or is incomplete.
    Warns of what is skipped, such as statements that OBJ files do not have.
    """
    place = pathlib.Path(file)
    return mesh_in(place, place.read_bytes())


def mesh_in(place: pathlib.Path, content: bytes) -> Arrays:
    """The mesh in a file with these bytes. Raises Error."""
    read = _core.read_mesh(place.suffix[1:].lower(), content)
    if read is None:
        raise _core.Error(f"{place}: this extension is no kind of mesh. Save it as .ply, .stl, .obj or .off.")
    vertices, faces, defect, remark = read
    if defect:
        raise _core.Error(f"{place} is incomplete: {defect}. Save it again from the program that wrote it.")
    if remark:
        warnings.warn(f"{place}: {remark}", stacklevel=3)
    return vertices, faces


def as_arrays(mesh: Any) -> Arrays:
    """Vertices, (n, 3) in the mesh's unit, and faces, (m, 3), of a mesh as other packages have it, or of a file.

    Raises TypeError or Error, which say what to give instead; of files as read_mesh().
    """
    if isinstance(mesh, (str, os.PathLike)):
        return read_mesh(mesh)
    vertices, faces = _parts(mesh)
    return _checked(vertices, float, "vertices").astype(numpy.float64, order="C", copy=False), _numbers(faces)


def _parts(mesh):
    if hasattr(mesh, "current_mesh"):  # of PyMeshLab
        mesh = mesh.current_mesh()
    if hasattr(mesh, "vertex_matrix"):
        return mesh.vertex_matrix(), mesh.face_matrix()
    if hasattr(mesh, "points") and hasattr(mesh, "extract_surface"):  # of PyVista
        if not hasattr(mesh, "faces"):
            raise TypeError(f"A {type(mesh).__name__} is no surface: give its extract_surface().")
        cells = numpy.asarray(mesh.faces).reshape(-1)
        if len(cells) % 4 or (cells[::4] != 3).any() or mesh.n_strips:
            mesh = mesh.triangulate()
        return mesh.points, numpy.asarray(mesh.faces).reshape(-1, 4)[:, 1:]
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # of trimesh
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "geometry") and hasattr(mesh, "to_mesh"):
        raise TypeError("A scene of trimesh may have several meshes: give its to_mesh(), which joins them.")
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return mesh
    raise TypeError(f"A {type(mesh).__name__} is no mesh that is known here: give a pair (vertices, faces) of arrays, a mesh of "
                    "trimesh, PyVista or PyMeshLab, or the name of a PLY, STL, OBJ or OFF file.")


def _checked(values, kind, name):
    array = numpy.asarray(values)
    if array.ndim != 2 or array.shape[1] != 3:
        what = "Polygons have to be split into triangles first." if name == "faces" else "Each row is x, y, z."
        raise _core.Error(f"The {name} have the shape {array.shape}, but must have (n, 3). {what}")
    if not numpy.issubdtype(array.dtype, numpy.integer) and not (kind is float and numpy.can_cast(array.dtype, float)):
        what = "numbers" if kind is float else "whole numbers, those of vertices"
        raise _core.Error(f"The {name} are of type {array.dtype}, but must be {what}.")
    return array


def _numbers(faces):
    array = _checked(faces, int, "faces")
    if array.size and (array.min() < 0 or array.max() > 0xffffffff):
        raise _core.Error(f"A face has the vertex {min(array.min(), 0) or array.max()}: vertices are counted from 0.")
    return array.astype(numpy.uint32, order="C", copy=False)
