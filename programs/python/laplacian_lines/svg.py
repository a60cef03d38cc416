# SPDX-License-Identifier: GPL-3.0-or-later
"""A view at true scale as SVG: what is seen of the lines, and nothing else. No sheet of several views, scale bar, section
or fitted curve, which the measured drawings of ./run --drawing and of the filter have."""

from __future__ import annotations

import itertools
import os
import typing
from typing import Any

import numpy
from numpy.typing import NDArray

from . import options
from .polylines import Polyline, Polylines
from .surface import Kinds, Point, visible_lines
from .whole_file import write_whole

if typing.TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._option_types import Options

UNITS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
_STEPS = 8  # of widths of a pen


@options.takes(options.LINES, options.FIELD, told="visible_lines()")
def write_svg(file: str | os.PathLike[str], mesh: Any, *, direction: Point = (0, 0, 1), up: Point = (0, 1, 0),
              unit: str = "mm", scale: float = 1, pen: float = 0.35, margin: float = 10,
              shortest: float = 1, kinds: Kinds = None, hidden: bool = False, **line_options: Unpack[Options]) -> Polylines:
    """Writes what is seen of a mesh's lines from a direction as SVG, at true scale.

    `unit` is that of the mesh: mm, cm, m or in. `scale` is drawn over true length: 0.5 for 1:2. `pen` is the width of a
    line of full weight, `margin` what is left around the drawing, `shortest` the length below which lines, with those that
    they go on to, are left out; all in mm on paper, which is as large as the drawing. Lines of a kind are a group of the
    file. `hidden` lines are dashed. What else it takes is that of visible_lines(), whose Polylines are returned; whole_lines,
    which suits paper, is on. Raises OSError, and what visible_lines() does.
    """
    if unit not in UNITS:
        raise ValueError(f"{unit!r} is not a unit of the mesh: say one of {', '.join(UNITS)}.")
    if not 0 < scale < numpy.inf:
        raise ValueError(f"scale is {scale!r}, but must be drawn length over true length, such as 0.5 for 1:2.")
    line_options.setdefault("whole_lines", True)
    lines = visible_lines(mesh, direction=direction, up=up, kinds=kinds, hidden=hidden, joined_in_picture=True,
                          **line_options)
    write_whole(file, _text(lines, UNITS[unit] * scale, pen, margin, shortest).encode())
    return lines


def _text(lines: Polylines, mm: float, pen: float, margin: float, shortest: float) -> str:
    drawn = lines.page if len(lines) else numpy.zeros((1, 2))
    low, high = drawn.min(axis=0) * mm, drawn.max(axis=0) * mm
    width, height = high - low + 2 * margin
    corner = numpy.array([margin - low[0], margin + high[1]])
    paths: dict[str, list[str]] = {}
    for line, is_kept in zip(lines, _is_long(lines, mm, shortest)):
        if is_kept:
            paths.setdefault(line.kind, []).append(_path(line, corner, mm, pen))
    groups = (f'<g id="{kind}">\n{"".join(of_kind)}</g>\n' for kind, of_kind in paths.items())
    return (f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="{width:.3f}mm" '
            f'height="{height:.3f}mm" viewBox="0 0 {width:.3f} {height:.3f}">\n<g fill="none" stroke="#000" '
            f'stroke-linecap="round" stroke-linejoin="round">\n{"".join(groups)}</g>\n</svg>\n')


def _is_long(lines: Polylines, mm: float, shortest: float) -> NDArray[numpy.bool_]:
    """Of each line, whether it is an outline or all that hangs together with it, end to end, is so long."""
    if not len(lines):
        return numpy.zeros(0, bool)
    first, end = lines.offsets[:-1], lines.offsets[1:]
    lengths = numpy.linalg.norm(numpy.diff(lines.page, axis=0, append=lines.page[-1:]), axis=1)
    lengths[end - 1] = 0
    places = numpy.rint(5 * mm * lines.page[numpy.concatenate([first, end - 1])])  # fifths of a millimetre
    place = numpy.unique(places, axis=0, return_inverse=True)[1].reshape(2, -1)
    label, before = numpy.arange(len(lines)), None
    while before is None or (label != before).any():
        before, least = label, numpy.full(place.size, len(lines))
        numpy.minimum.at(least, place.ravel(), numpy.tile(label, 2))
        label = least[place].min(axis=0)
    total = numpy.bincount(label, numpy.add.reduceat(lengths, first))[label]
    return lines.outline | (total * mm >= shortest)


def _path(line: Polyline, corner, mm: float, pen: float) -> str:
    """A path for each run of segments of about equal width: outlines bolder, what fades thinner."""
    places = corner + line.page * (mm, -mm)
    strength = line.weights * line.opacities
    factor = 1.4 if line.outline else 1
    steps = numpy.ceil(_STEPS * (strength[1:] + strength[:-1]) / 2).astype(int)
    dash = f' stroke-dasharray="{4 * pen:g} {2 * pen:g}" stroke-linecap="butt"' if line.hidden else ""
    paths, first = [], 0
    for step, run in itertools.groupby(steps):
        last = first + len(list(run))
        if step > 0:
            data = " ".join(f"{x:.3f},{y:.3f}" for x, y in places[first : last + 1])
            paths.append(f'<path stroke-width="{factor * pen * step / _STEPS:.3f}"{dash} d="M{data}"/>\n')
        first = last
    return "".join(paths)
