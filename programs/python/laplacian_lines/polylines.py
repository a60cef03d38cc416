# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as arrays."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterator, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _core


class Kind(NamedTuple):
    """A kind of lines; its place in KINDS is its number in arrays."""

    key: str
    one: str  # "ridge"
    many: str  # "ridges"
    outline: bool  # bounds the form; the others describe what is inside
    color: int  # 0xRRGGBB
    width: float  # in widths of a Laplacian line of full weight


KINDS = tuple(Kind(**row) for row in _core.kinds)
Vector = NDArray[numpy.float64]


@dataclasses.dataclass(frozen=True, eq=False)
class Page:
    """The plane of a picture, and the projection to it."""

    right: Vector  #: (3,), unit
    up: Vector  #: (3,), unit
    towards_viewer: Vector  #: (3,), unit
    eye: Vector | None  #: (3,), of a perspective view

    def place(self, points: NDArray[Any]) -> Vector:
        """(n, 3) points of space on the page, (n, 2), x to the right and y up, in the mesh's unit.

        In perspective they are slopes: offsets in a plane at the distance 1 from the eye; NaN behind it.
        """
        axes = numpy.stack([self.right, self.up]).T
        if self.eye is None:
            return points @ axes
        rays = points - self.eye
        depths = -rays @ self.towards_viewer
        return rays @ axes / numpy.where(depths > 0, depths, numpy.nan)[:, None]


class Polyline(NamedTuple):
    """A line; arrays are views of those of its Polylines."""

    kind: str  #: a key of KINDS, such as "ridges"
    points: Vector  #: (k, 3), in the mesh's coordinates; a closed line ends with its first point
    page: Vector  #: (k, 2), see Page.place()
    weights: NDArray[numpy.float32]  #: (k,), shares of the full width, 0 to 1
    opacities: NDArray[numpy.float32]  #: (k,), 0 to 1; lines that are about to vanish are nearly transparent
    closed: bool
    hidden: bool
    outline: bool


@dataclasses.dataclass(frozen=True, eq=False)
class Polylines:
    """Lines of a view: a sequence of Polyline without slices, kept as arrays over all of their points and over all lines.

    Points of line i are those from offsets[i] to offsets[i + 1].
    """

    points: Vector  #: (p, 3), in the mesh's coordinates and unit
    page: Vector  #: (p, 2), the same on the page, see Page.place()
    weights: NDArray[numpy.float32]  #: (p,), shares of the full width, 0 to 1
    opacities: NDArray[numpy.float32]  #: (p,), 0 to 1
    #: (p,), how much the shading changes across the line, or by how many degrees the surface turns; see docs/script.md
    gradients: NDArray[numpy.float32]
    offsets: NDArray[numpy.int64]  #: (l + 1,)
    kinds: NDArray[numpy.uint8]  #: (l,), places in KINDS
    strengths: NDArray[numpy.float32]  #: (l,), of Laplacian lines and contours: the paper's Eq. 4, no unit
    closed: NDArray[numpy.bool_]  #: (l,)
    hidden: NDArray[numpy.bool_]  #: (l,), behind the surface; lines() does not ask, and says False
    outline: NDArray[numpy.bool_]  #: (l,), contours and borders with nothing behind them; lines() does not ask
    plane: Page

    @classmethod
    def of_core(cls, arrays: dict[str, Any], plane: Page) -> Polylines:
        """Of what the core's functions return."""
        flags = {name: arrays.pop(name).view(numpy.bool_) for name in ("closed", "hidden", "outline")}
        return cls(page=plane.place(arrays["points"]), plane=plane, **arrays, **flags)

    def __len__(self) -> int:
        return len(self.kinds)

    def __getitem__(self, number: int) -> Polyline:
        number = range(len(self))[number]
        part = slice(self.offsets[number], self.offsets[number + 1])
        return Polyline(KINDS[self.kinds[number]].key, self.points[part], self.page[part], self.weights[part],
                        self.opacities[part], bool(self.closed[number]), bool(self.hidden[number]),
                        bool(self.outline[number]))

    def __iter__(self) -> Iterator[Polyline]:
        return (self[i] for i in range(len(self)))

    def by_kind(self) -> dict[str, list[Polyline]]:
        """Lines by the keys of their kinds, of those kinds that there are."""
        sorted_lines: dict[str, list[Polyline]] = {KINDS[kind].key: [] for kind in numpy.unique(self.kinds)}
        for line in self:
            sorted_lines[line.kind].append(line)
        return sorted_lines

    def __repr__(self) -> str:
        counts = ", ".join(f"{(self.kinds == k).sum()} {KINDS[k].many}" for k in numpy.unique(self.kinds))
        return f"<Polylines: {counts or 'none'}; {len(self.points)} points>"
