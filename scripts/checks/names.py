# SPDX-License-Identifier: GPL-3.0-or-later
"""One convention of names in all C++: functions and variables are snake_case, types and enumerators CamelCase, constants of
files and classes kCamelCase. What overrides a function of Qt or MeshLab has its name; a private member ends in _."""

import json
import re

from environment.messages import output

SNAKE, CAMEL, CONSTANT = r"~?[a-z][a-z0-9]*(_[a-z0-9]+)*_*", r"[A-Z][A-Za-z0-9]*", r"k[A-Z0-9][A-Za-z0-9]*"
# Of the papers, as S and C; as Eigen has them; what others look for by name; macros that look like functions.
OTHERS = r"[A-Z]|__\w+|squaredNorm|GoodObjIndex|LLVMFuzzerTestOneInput|[A-Z][A-Z_]+(_P)?|operator.*"
RULES = {
    "function": f"{SNAKE}|{OTHERS}", "prototype": f"{SNAKE}|{OTHERS}", "slot": SNAKE, "local": f"{SNAKE}|{CONSTANT}|_",
    "parameter": f"{SNAKE}|{CONSTANT}|{CAMEL}", "member": f"{SNAKE}|{CONSTANT}", "private": rf"\w+_|{CONSTANT}", "variable": f"{SNAKE}|{CONSTANT}",
    "constant": f"{CONSTANT}|operator.*", "class": CAMEL, "struct": CAMEL, "enum": CAMEL, "typedef": CAMEL, "enumerator": f"{CAMEL}|{CONSTANT}"}


def wrong_names(files):
    """FILE:LINE: NAME of each that follows another convention."""
    tags = map(json.loads, output("ctags", "--kinds-C++=+pxlz", "--fields=+KsSna", "--langmap=C++:.cpp.h", "--output-format=json",
                                  "-f", "-", *files).splitlines())
    tags = [tag for tag in tags if tag["_type"] == "tag" and not tag["name"].startswith("__anon") and "&" not in tag["name"]]
    lines = {str(file): file.read_text().split("\n") for file in files}

    def statement(tag):
        """From the line of the name to the end of what is declared."""
        return re.split("[;{]", " ".join(lines[tag["path"]][tag["line"] - 1:tag["line"] + 3]))[0]

    overrides = {tag["name"] for tag in tags if re.search(r"\b(override|final)\b", statement(tag))}
    for tag in tags:
        name, kind, owner = tag["name"], tag["kind"], tag.get("scope", "").split("::")[-1]
        if kind == "variable" and re.match(r"\s*(static |inline )*(constexpr|const) (?!.*\*\s)", lines[tag["path"]][tag["line"] - 1]):
            kind = "constant"
        if kind == "member" and tag.get("access") == "private":
            kind = "private"
        if kind in RULES and name not in overrides and name.lstrip("~") != owner and not re.fullmatch(RULES[kind], name):
            yield f"{tag['path']}:{tag['line']}: {name}"
