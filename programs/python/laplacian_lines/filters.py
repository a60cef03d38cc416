# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters as methods of pymeshlab.MeshSet, with signatures and docstrings from the plugin's tables."""

import html
import inspect
import os
import pathlib
import re
import tempfile
import textwrap
import warnings

from .tables import filter_row, parameters
from .whole_file import write_whole


def method(name):
    """A method of MeshSet that calls a filter by its name in PyMeshLab."""

    def call(self, **given):
        results = _apply(self, name, with_choices(name, given))
        if results.get("sees_all") is False:
            warnings.warn("Not all of the mesh is in sight: the viewpoint is within its bounding box or close to it. "
                          'Take one farther away, or one of the sides, such as view="Front".', stacklevel=2)
        return results or None

    call.__name__ = call.__qualname__ = name
    call.__doc__ = _help(name)
    call.__signature__ = _signature(name)
    return call


def _apply(meshes, name, given):
    """The filter's results. Files may be named as in open(); PyMeshLab itself takes names that are UTF-8."""
    if "file" not in given:
        return meshes.apply_filter(name, **given)
    file = os.fsdecode(given["file"])
    if not any("\ud800" <= c <= "\udfff" for c in file):
        return meshes.apply_filter(name, **{**given, "file": file})
    with tempfile.TemporaryDirectory() as folder:
        drawing = pathlib.Path(folder) / f"drawing{pathlib.Path(file).suffix}"
        results = meshes.apply_filter(name, **{**given, "file": str(drawing)})
        write_whole(file, drawing.read_bytes())
    return results


def with_choices(name, given):
    """The given parameters, with the choice that makes a given point or direction count.

    `viewpoint=...` alone means view="Perspective, from the Viewpoint", for instance. Warns of a point that does not
    count because something else was chosen; raises ValueError if two points want different choices.
    """
    rows = {row["key"]: row for row in filter_row(name)["parameters"]}
    completed = dict(given)
    for place in (rows[key] for key in given if "counts_by" in rows.get(key, {})):
        key, chooser, number = place["key"], place["counts_by"], place["counts_at"]
        words = rows[chooser]["choices"][number]
        if chooser in given:
            if given[chooser] not in (number, words):
                warnings.warn(f"{key} has no effect with {chooser}={given[chooser]!r}, only with {chooser}={words!r}.",
                              stacklevel=3)
        elif completed.get(chooser, words) != words:
            raise ValueError(f"{key} needs {chooser}={words!r}, which other parameters contradict. Give {chooser}.")
        else:
            completed[chooser] = words
    return completed


def summary(name):
    """The call of a filter and its parameters, as text."""
    return f"MeshSet.{name}(...)\n{textwrap.indent(_parameter_text(name), '    ')}"


class _AsPython(str):
    """A default that is shown as Python writes it."""

    __repr__ = str.__str__


def _signature(name):
    self = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)
    return inspect.Signature([self] + [
        inspect.Parameter(p.name, inspect.Parameter.KEYWORD_ONLY, default=_AsPython(p.shown_default()))
        for p in parameters(name)])


def _parameter_text(name):
    lines = repr(parameters(name)).splitlines()
    return "\n".join(textwrap.fill(line, 110, subsequent_indent="    ") for line in lines)


def _help(name):
    text = re.sub(r"<br>", "\n", filter_row(name)["help"])
    text = html.unescape(re.sub(r"<[^>]*>", "", text))
    paragraphs = "\n".join(textwrap.fill(line, 110) for line in text.splitlines())
    return f"{paragraphs}\n\nParameters\n----------\n{_parameter_text(name)}\n"
