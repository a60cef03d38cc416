# SPDX-License-Identifier: GPL-3.0-or-later
"""The field of a mesh and its lines, as NumPy arrays."""

from __future__ import annotations

import typing
from typing import Any, Iterable, NamedTuple, Sequence

import numpy
from numpy.typing import NDArray

from . import _core, options
from .meshes import as_arrays
from .polylines import Page, Polylines, Vector

if typing.TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._option_types import FieldOptions, LineOptions, Options


class Attribute(NamedTuple):
    """What a field has under a name; some columns of the core's field are in two attributes."""

    name: str
    numbers: int  # a vertex: 3 or 1
    help: str  # on the column
    unit: str  # empty if it has none
    optional: bool  # whether a field may be without it


ATTRIBUTES = tuple(Attribute(**row) for row in _core.columns)
Point = Sequence[float] | Vector
Kinds = str | Iterable[str] | None


class Surface:
    """A mesh with its field, prepared once for many views.

    `mesh` is what as_arrays() takes. The options, those of the field, and all computing are the core's, which runs on
    several threads, without Python's lock: other threads go on, and may use the same Surface. Ctrl-C ends it.
    Raises Error if an option is out of its limits or the mesh has no surface.
    """

    @options.takes(options.FIELD)
    def __init__(self, mesh: Any, **field_options: Unpack[FieldOptions]) -> None:
        vertices, faces = as_arrays(mesh)
        self._core = _core.Surface(vertices, faces, options.values(dict(field_options), options.FIELD))
        finite = vertices[numpy.isfinite(vertices).all(axis=1)]
        self._centre = (finite.min(axis=0) + finite.max(axis=0)) / 2

    def field(self) -> dict[str, NDArray[numpy.float32]]:
        """Normals, their Laplacian, curvature and kernel at each vertex, see the function field()."""
        return self._core.field()

    def measures(self) -> dict[str, float]:
        """Of the whole mesh, by name.

        In its unit: diagonal (of the bounding box), mean_edge, kernel_size √h and normal_sigma (of smoothing), as they were
        used. Without unit: roughness (of clean meshes 0). Counts of what was dropped: non_finite_vertices,
        unreferenced_vertices, degenerate_triangles. Counts of repairs: welded_vertices; flipped_triangles, whose orientation
        was reversed because they faced inwards or unlike their neighbours. Fields and lines are those of the repaired mesh;
        lines also of what refining and undoing midpoint subdivisions make of it.
        """
        return self._core.measures()

    @options.takes(options.LINES)
    def lines(self, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
              light: Point | None = None, kinds: Kinds = None, **line_options: Unpack[LineOptions]) -> Polylines:
        """All lines of a view, also those that the surface hides; see the function lines()."""
        plane, view = self._view(direction, eye, up, light)
        return Polylines.of_core(self._core.lines(*view, _style(kinds, line_options)), plane)

    @options.takes(options.LINES, documented_in="lines()")
    def visible_lines(self, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
                      light: Point | None = None, kinds: Kinds = None, hidden: bool = False,
                      joined_in_picture: bool = False, **line_options: Unpack[LineOptions]) -> Polylines:
        """The parts of lines that are seen; see the function visible_lines()."""
        plane, view = self._view(direction, eye, up, light)
        arrays = self._core.visible_lines(*view, _style(kinds, line_options), hidden, joined_in_picture)
        return Polylines.of_core(arrays, plane)

    @options.takes(options.LINES, documented_in="lines()")
    def strokes(self, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
                light: Point | None = None, kinds: Kinds = None, size: float = 200,
                **line_options: Unpack[LineOptions]) -> Polylines:
        """The strokes of a drawing; see the function strokes()."""
        if not 1 <= size <= 10000:
            raise ValueError(f"size is {size!r}, but must be the length of the view's longer side, 1 to 10000 mm.")
        plane, (_, _, light) = self._view(direction, eye, up, light)
        axes = numpy.stack([plane.right, plane.up, plane.towards_viewer])
        light = None if light is None else (axes @ light).tolist()
        eye = None if plane.eye is None else plane.eye.tolist()
        arrays = self._core.strokes(axes.tolist(), eye, light, _style(kinds, line_options), float(size))
        return Polylines.of_core(arrays, plane)

    def _view(self, direction, eye, up, light):
        """The plane of the picture; the eye and the light as the core has them."""
        if direction is None and eye is None:
            raise TypeError("Say from where: direction=(0, 0, 1), to a viewer far away, or eye=(x, y, z), a place.")
        eye = None if eye is None else _vector(eye, "eye")
        if direction is not None:
            back = _unit(_vector(direction, "direction"), "direction")
        else:
            back = _unit(eye - self._centre, "the way from the mesh's middle to the eye", "give a direction, too")
        up = _unit(_vector(up, "up"), "up")
        if numpy.linalg.norm(numpy.cross(up, back)) < 1e-6:  # from above or below, as in drawings: the front is down or up
            front = numpy.array((0, -1, 0) if abs(up[2]) > 0.5 else (0, 0, 1))
            up = -front if up @ back > 0 else front
        right = _unit(numpy.cross(up, back), "up, across the direction,")
        plane = Page(right, numpy.cross(back, right), back, eye)
        light = None if light is None else _vector(light, "light").tolist()
        return plane, ((back if eye is None else eye).tolist(), float(eye is not None), light)


def _vector(values, name):
    vector = numpy.asarray(values, dtype=float)
    if vector.shape != (3,) or not numpy.isfinite(vector).all():
        raise ValueError(f"{name} is {values!r}, but must be three finite numbers.")
    return vector


def _unit(vector, name, advice="give another"):
    vector = numpy.ldexp(vector, -numpy.frexp(abs(vector).max())[1])  # whose squares are numbers, too
    length = numpy.linalg.norm(vector)
    if length == 0:
        raise ValueError(f"{name} has no length: {advice}.")
    return vector / length


def _style(kinds, given):
    """The style as numbers by key: `kinds` sets all switches, and options named by kinds change them."""
    style = options.values(given, options.LINES)
    if kinds is None:
        return style
    chosen = set(_core.keys_of_kinds(kinds if isinstance(kinds, str) else ",".join(kinds)))
    return {**{kind["key"]: float(kind["key"] in chosen) for kind in _core.kinds}, **style}


def _surface(mesh, given):
    """The surface of a mesh with those of the options that are the field's, and the others."""
    others = dict(given)
    of_field = {key: others.pop(key) for key in given if key in options.FIELD}
    if not isinstance(mesh, Surface):
        return Surface(mesh, **of_field), others
    if of_field:
        raise TypeError(f"A Surface has its field: give {', '.join(of_field)} to Surface(mesh, ...).")
    return mesh, others


@options.takes(options.FIELD, documented_in="Surface()")
def field(mesh: Any, **field_options: Unpack[FieldOptions]) -> dict[str, NDArray[numpy.float32]]:
    """Normals n, their Laplacian Δn, the derivative S of n (curvature) and the kernel's size at each vertex of a mesh.

    Returns arrays by the names in ATTRIBUTES, which says what they are: (vertices, 3) or (vertices,), in powers of the
    mesh's unit. Vertices in no face hold zeros. A sphere of radius R with outward normals has S with the eigenvalues
    1/R, 1/R, 0 and Δn = −2/R² n. Raises Error if an option is out of its limits or the mesh has no surface.
    """
    if isinstance(mesh, Surface):
        raise TypeError("A Surface has its field: surface.field().")
    return Surface(mesh, **field_options).field()


@options.takes(options.LINES, options.FIELD, documented_in="Surface.lines(), and of Surface() for the field")
def lines(mesh: Any, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
          light: Point | None = None, kinds: Kinds = None, **line_options: Unpack[Options]) -> Polylines:
    """All lines of a mesh as they are drawn in a view, also those that the surface hides.

    `mesh` is a Surface or what as_arrays() takes. The viewer is far away in a `direction`, or at the place `eye`, in the
    mesh's coordinates; `up` is upward on the page. `light` is the direction to a distant light, whose shading the Laplacian
    lines draw; without one it is at the eye. `kinds` are names of kinds or mixtures, "ridges, valleys" or a list; the usual
    ones if none are given; the outlines are always among them. Returns Polylines. Raises Error if an option is out of its
    limits, the mesh has no surface or a kind is not known.
    """
    surface, of_lines = _surface(mesh, line_options)
    return surface.lines(direction=direction, eye=eye, up=up, light=light, kinds=kinds, **of_lines)


@options.takes(options.LINES, options.FIELD, documented_in="Surface.lines(), and of Surface() for the field")
def visible_lines(mesh: Any, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
                  light: Point | None = None, kinds: Kinds = None, hidden: bool = False,
                  joined_in_picture: bool = False, **line_options: Unpack[Options]) -> Polylines:
    """The parts of a mesh's lines that are seen in a view, cut exactly where the surface hides them.

    What lines() takes. Outlines, borders and creases are edges of the mesh. With `hidden`, Polylines.hidden says which ones
    are behind the surface: of outlines, borders and creases. With `joined_in_picture`, lines go on as in the picture, from
    what is before to what is behind it, so that outlines are closed. Returns Polylines, whose `page` is the drawing.
    """
    surface, of_lines = _surface(mesh, line_options)
    return surface.visible_lines(direction=direction, eye=eye, up=up, light=light, kinds=kinds, hidden=hidden,
                                 joined_in_picture=joined_in_picture, **of_lines)


@options.takes(options.LINES, options.FIELD, documented_in="Surface.lines(), and of Surface() for the field")
def strokes(mesh: Any, *, direction: Point | None = None, eye: Point | None = None, up: Point = (0, 1, 0),
            light: Point | None = None, kinds: Kinds = None, size: float = 200, **line_options: Unpack[Options]) -> Polylines:
    """The strokes that a drawing of the view has, in space: seen, joined, thinned out, smooth.

    What lines() takes. `size` is the length of the longer side of the drawing, mm on paper, which decides about kernel and
    pens; a `kernel_size` of the field counts more. Each point is as deep as the line that it comes from; a stroke ends where
    its line goes on behind another. Returns Polylines, whose `page` is the drawing and whose `kinds` are those of most of a
    stroke.
    """
    surface, of_lines = _surface(mesh, line_options)
    return surface.strokes(direction=direction, eye=eye, up=up, light=light, kinds=kinds, size=size, **of_lines)
