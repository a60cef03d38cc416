# SPDX-License-Identifier: GPL-3.0-or-later
"""Options as keyword arguments: names, defaults, limits and help are those of the core's tables."""

from __future__ import annotations

import difflib
import html
import inspect
import numbers
import textwrap
from typing import Any, Callable, Iterable, TypeVar

from . import _core

_TYPES = {"real": float, "length": float, "boolean": bool, "choice": str | int, "text": str | Iterable[str]}
FIELD = {row["key"]: row for row in _core.field_options}
LINES = {row["key"]: row for row in _core.line_options}
SHEET = {row["key"]: row for row in _core.sheet_options}
_Function = TypeVar("_Function", bound=Callable[..., Any])


def takes(*tables: dict[str, dict[str, Any]], documented_in: str = "") -> Callable[[_Function], _Function]:
    """Shows the options of these tables in the signature and the docstring of a function that takes them as **options.

    With `documented_in`, the docstring refers to that function instead of describing them.
    """
    rows = [row for table in tables for row in table.values()]

    def show(function: _Function) -> _Function:
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        shown = [inspect.Parameter(row["key"], inspect.Parameter.KEYWORD_ONLY, default=_default(row),
                                   annotation=_TYPES[row["kind"]]) for row in rows]
        function.__signature__ = signature.replace(parameters=own + shown)  # type: ignore[attr-defined]
        text = f"Those of {documented_in}." if documented_in else "\n".join(map(_described, rows))
        function.__doc__ = (f"{inspect.cleandoc(function.__doc__ or '')}\n\nOptions\n-------\n"
                            f"{textwrap.indent(text, '    ')}\n")
        return function

    return show


def values(given: dict[str, Any], table: dict[str, dict[str, Any]]) -> dict[str, float]:
    """The given options as numbers for the core. Raises TypeError if one is not in the table or is of a wrong type."""
    return {key: _number(_row(key, table), value) for key, value in given.items()}


def words(given: dict[str, Any], table: dict[str, dict[str, Any]]) -> list[str]:
    """The given options as the command has them, "--paper", "a3". Raises as values()."""
    rows = {key: _row(key, table) for key in given}
    return [word for key, row in rows.items() for word in (row["command"], _word(row, given[key]))]


def _row(key, table):
    if key in table:
        return table[key]
    close = difflib.get_close_matches(key, list(table), 3, 0.5)
    raise TypeError(f"There is no option {key!r}. {'Did you mean' if close else 'Options are'} "
                    f"{', '.join(close or table)}{'?' if close else '.'}")


def _word(row, value):
    if row["kind"] == "real":
        return repr(_number(row, value)).removesuffix(".0")
    if row["kind"] != "text":
        return row["words"][int(_number(row, value))]
    parts = [value] if isinstance(value, str) else list(value)
    if not all(isinstance(part, str) for part in parts):
        raise TypeError(f"{row['key']} is {value!r}, but must be a text or several.")
    return ",".join(parts)


def _number(row, value):
    """A core's number for a value; whether it is within its limits is for the core to say."""
    choices = [choice.lower() for choice in row["choices"]]
    if choices:
        if isinstance(value, str) and value.lower() in choices:
            return float(choices.index(value.lower()))
        if isinstance(value, numbers.Integral) and 0 <= value < len(choices):
            return float(value)
        raise TypeError(f"{row['key']} is {value!r}, but must be {_values(row)}.")
    if isinstance(value, str) or not hasattr(value, "__float__") or (row["kind"] == "boolean" and value not in (0, 1)):
        raise TypeError(f"{row['key']} is {value!r}, but must be of type {_TYPES[row['kind']].__name__}.")
    return float(value)


def _default(row):
    if row["choices"]:
        return row["choices"][int(row["default"])]
    return bool(row["default"]) if row["kind"] == "boolean" else row["default"]


def _values(row):
    if row["choices"]:
        return ", ".join(repr(choice) for choice in row["choices"])
    if row["kind"] in ("boolean", "text"):
        return ""
    return f"{row['minimum']:g} {'or more' if row['maximum'] is None else 'to {:g}'.format(row['maximum'])}"


def _described(row):
    limits = f"{_values(row)}. " if _values(row) else ""
    text = textwrap.fill(limits + html.unescape(row["help"]), 106, initial_indent="    ", subsequent_indent="    ")
    kind = inspect.formatannotation(_TYPES[row["kind"]])
    return f"{row['key']}: {kind} = {_default(row)!r}\n{text}"
