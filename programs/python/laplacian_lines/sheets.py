# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings: views at scale on paper, as ./run --drawing makes them, byte for byte."""

from __future__ import annotations

import hashlib
import os
import pathlib
import typing
from typing import Any

from . import _core, options
from .meshes import as_arrays, mesh_in

if typing.TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._option_types import SheetOptions


class Drawing(typing.NamedTuple):
    """A measured drawing. Notebooks show one that is SVG."""

    content: bytes  # of a file
    format: str  # "svg", "pdf", "dxf" or "png"
    paper: tuple[float, float]  # width and height, mm
    scale: float  # drawn over true length, 0.5 for 1:2; 0: in perspective
    kernel: float  # √h of the inner lines, mm on paper; 0 if there are none, or the mesh is too coarse
    remarks: tuple[str, ...]  # what is to be said of it besides

    def _repr_svg_(self) -> str | None:
        return self.content.decode() if self.format == "svg" else None


@options.takes(options.SHEET)
def make_drawing(*meshes: Any, format: str = "svg", **sheet_options: Unpack[SheetOptions]) -> Drawing:
    """Draws meshes together, which hide each other: their lines from several sides, at one scale, laid out on paper.

    `meshes` are what as_arrays() takes, in one coordinate system; the names of files are in the drawing's note. The fields
    are computed for the drawing's scale. `format` is "svg", in millimetres, with layers by views and kinds, "pdf", "dxf" or
    "png".
    The same meshes and options give the same bytes, which are those of the command. Raises Error if an option cannot be
    used, the drawing does not fit its paper at its scale, or a mesh has no surface; TypeError; OSError.
    """
    format = format.lower()
    words = options.words(dict(sheet_options), options.SHEET)
    return Drawing(format=format, **_core.draw([_named(mesh) for mesh in meshes], words, format))


@options.takes(options.SHEET, documented_in="make_drawing()")
def write_drawing(file: str | os.PathLike[str], *meshes: Any, **sheet_options: Unpack[SheetOptions]) -> Drawing:
    """Writes a measured drawing of meshes, see make_drawing(), in the format that the ending of the file's name says.

    A file that was there is replaced, once the drawing is there as a whole. Returns the Drawing.
    """
    drawing = make_drawing(*meshes, format=pathlib.Path(file).suffix[1:], **sheet_options)
    try:
        _core.write_atomically(os.fsencode(file), drawing.content)
    except _core.Error as error:
        raise OSError(str(error)) from None
    return drawing


def _named(mesh):
    """The arrays of a mesh, and the name and hash of its file."""
    if not isinstance(mesh, (str, os.PathLike)):
        return (*as_arrays(mesh), "", "")
    place = pathlib.Path(mesh)
    content = place.read_bytes()
    name = place.name.translate(dict.fromkeys(range(0xdc80, 0xdd00), "\ufffd"))  # for each byte that is no letter
    return (*mesh_in(place, content), name, hashlib.sha256(content).hexdigest())
