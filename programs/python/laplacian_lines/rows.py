# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of the tables of the core, whether the wheel or the plugin has them."""

import typing


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
