# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the options of the core's tables as types: write_option_types.py FOLDER_OF_CORE FILE.pyi"""

import html
import sys
import textwrap

sys.path.insert(0, sys.argv[1])

import _core


def type_of(row):
    if row["kind"] == "choice":
        return f"Literal[{', '.join(repr(choice) for choice in row['choices'])}] | int"
    return {"boolean": "bool", "text": "str | Iterable[str]"}.get(row["kind"], "float")


def typed_dict(name, rows):
    members = [f"    {row['key']}: {type_of(row)}\n" + textwrap.indent(f'"""{html.unescape(row["help"])}"""\n', "    ")
               for row in rows]
    return f"class {name}(TypedDict, total=False):\n" + "".join(members)


with open(sys.argv[2], "w", encoding="utf-8") as file:
    file.write("from typing import Iterable, Literal, TypedDict\n\n")
    file.write(typed_dict("FieldOptions", _core.field_options) + "\n")
    file.write(typed_dict("LineOptions", _core.line_options) + "\n")
    file.write(typed_dict("SheetOptions", _core.sheet_options) + "\n")
    file.write("class Options(FieldOptions, LineOptions, total=False): ...\n")
