# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's own tables: its filters with their parameters, what a field has, the kinds of lines."""

import ctypes
import html
import json
import typing

import pymeshlab  # has loaded the libraries that the plugin needs

from .shared import FILTER, PLUGIN, Attribute, Kind

POLYLINE_FILTER = "generate_polyline_from_laplacian_lines"
DRAWING_FILTER = "export_laplacian_lines_drawing"


def _read(plugin):
    try:
        library = ctypes.CDLL(str(plugin))
    except OSError as error:
        raise ImportError(
            f"The plugin of Laplacian lines cannot be used with this PyMeshLab ({error}). Build it for this version: "
            "./run --python builds it for the one that it installs; LAPLACIAN_LINES_PLUGIN may name the file.",
            name="laplacian_lines", path=str(plugin)) from error
    library.laplacian_lines_tables.restype = ctypes.c_char_p
    return json.loads(library.laplacian_lines_tables().decode())


class Parameter(typing.NamedTuple):
    """A parameter of a filter."""

    name: str
    type: str  # what Python gives it
    default: object  # None for places, which depend on the mesh
    values: str  # what it may be, empty if that is anything of its type
    help: str

    def __str__(self):
        default = "" if self.default is None else f" = {self.shown_default()}"
        values = f"{self.values}. " if self.values else ""
        return f"{self.name}: {self.type}{default}\n    {values}{self.help}"

    def shown_default(self):
        """As one would write it in Python, `...` if it depends on the mesh."""
        if isinstance(self.default, pymeshlab.PureValue):
            return f"PureValue({self.default.value():g})"
        return "..." if self.default is None else repr(self.default)


class Parameters(tuple):
    """Parameters of a filter, in the order of its dialog; printed, they are a text for people."""

    def __repr__(self):
        return "\n".join(str(parameter) for parameter in self)


_TABLES = _read(PLUGIN)
ATTRIBUTES = tuple(Attribute(**row) for row in _TABLES["columns"])
KINDS = tuple(Kind(**row) for row in _TABLES["kinds"])
_TYPES = {"real": "float", "integer": "int", "boolean": "bool", "choice": "str or int", "text": "str",
          "place": "three numbers", "length": "PureValue or PercentageValue"}
_NUMBERS = {"real": float, "integer": int, "length": lambda value: pymeshlab.PureValue(float(value))}


def filter_row(name):
    """The table of a filter by its name in PyMeshLab. Raises ValueError if there is none."""
    for row in _TABLES["filters"]:
        if row["python_name"] == name:
            return row
    names = " or ".join(repr(row["python_name"]) for row in _TABLES["filters"])
    raise ValueError(f"There is no filter {name!r}, but {names}.")


def parameters(name=FILTER):
    """The parameters of a filter, FILTER, POLYLINE_FILTER or DRAWING_FILTER; printed, a text that tells what they do.

    Raises ValueError if there is no such filter.
    """
    return Parameters(_parameter(row) for row in filter_row(name)["parameters"])


def _parameter(row):
    default = row.get("default")
    if row["kind"] == "choice":
        default = row["choices"][int(default)]
    elif row["kind"] in _NUMBERS:
        default = _NUMBERS[row["kind"]](default)
    return Parameter(row["key"], _TYPES[row["kind"]], default, _values(row), html.unescape(row["help"]))


def _values(row):
    if row["kind"] == "choice":
        return ", ".join(f"{number} {words!r}" for number, words in enumerate(row["choices"]))
    if "maximum" in row:
        return f"{row['minimum']:g} to {row['maximum']:g}"
    return f"{row['minimum']:g} or more" if "minimum" in row else ""
