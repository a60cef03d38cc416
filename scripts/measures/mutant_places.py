# SPDX-License-Identifier: GPL-3.0-or-later
"""mutant_places.py CHECKOUT DATABASE FOLDER...: the places of C++ sources in these folders at which a mutant can be
switched on while the program runs, as JSON, found by libclang in what a database of CMake compiles. A place has edits
(begin, end, text) of the file's bytes, in which @ stands for the mutant's number."""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import sys

import clang.cindex
from clang.cindex import CursorKind as Kind, TypeKind

NEGATED = {"<": (">=", "less_to_not"), ">": ("<=", "more_to_not"), "<=": (">", "at_most_to_not"),
           ">=": ("<", "at_least_to_not"), "==": ("!=", "equal_to_not"), "!=": ("==", "not_to_equal")}
SHIFTED = {"<": ("<=", "less_to_at_most"), ">": (">=", "more_to_at_least"), "<=": ("<", "at_most_to_less"),
           ">=": (">", "at_least_to_more")}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.FUNCTION_TEMPLATE,
             Kind.CONVERSION_FUNCTION}
FLOATS = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}
INTEGERS = {TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG,
            TypeKind.SHORT, TypeKind.USHORT, TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.UCHAR}
VALUES = (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.CALL_EXPR, Kind.RETURN_STMT,
          Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR, Kind.CONDITIONAL_OPERATOR)  # of which an integer may be one that varies
STATEMENTS = Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.UNARY_OPERATOR, \
    Kind.UNEXPOSED_EXPR


read = set()  # files, of those in this process


def words_for_clang(command):
    """Without what names the output, the source and headers that GCC has compiled before."""
    words, kept = command[1:], []
    while words:
        word = words.pop(0)
        if word in ("-o", "-include"):
            words.pop(0)
        elif word not in ("-c", "--", "-Winvalid-pch", "-Werror"):
            kept.append(word)
    return kept


def places_in(root, command, folders):
    """Those of a source and of the headers that it includes, in these folders of a checkout, by how it is compiled."""
    unit = clang.cindex.Index.create().parse(command[-1], words_for_clang(command[:-1]))
    search, wanted = Search(root), {}
    for cursor in unit.cursor.get_children():
        name = cursor.location.file and cursor.location.file.name
        if name not in wanted:
            file = os.path.relpath(os.path.realpath(name or "/"), root)
            # public headers: changing one would recompile all tests
            wanted[name] = file.startswith(folders) and "/include/" not in file and file not in read
            read.add(file)
        if wanted[name]:
            search.walk(cursor, None, None)
    return search.found


class Search:
    def __init__(self, root):
        self.root, self.found, self.texts = root, [], {}

    def text(self, cursor, begin=None, end=None):
        file = cursor.extent.start.file.name
        if file not in self.texts:
            self.texts[file] = pathlib.Path(file).read_bytes()
        first = cursor.extent.start.offset if begin is None else begin
        return self.texts[file][first:cursor.extent.end.offset if end is None else end].decode(errors="replace")

    def add(self, cursor, kind, change, *edits):
        file = os.path.relpath(os.path.realpath(cursor.extent.start.file.name), self.root)
        lines = cursor.extent.start.line, cursor.extent.start.line if kind == "return" else cursor.extent.end.line
        change = " ".join(change.split())
        self.found.append({"file": file, "lines": lines, "kind": kind, "change": change, "edits": edits})

    def walk(self, cursor, parent, function):
        kind = cursor.kind
        if not cursor.extent.start.file or kind in (Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.TEMPLATE_REF):
            return
        children = list(cursor.get_children())
        if kind in FUNCTIONS:
            bodies = [child for child in children if child.kind == Kind.COMPOUND_STMT]
            if not bodies or re.search(r"\bconst(expr|eval)\b",
                                       self.text(cursor, end=bodies[0].extent.start.offset)):
                return
            function = cursor
            self.early_return(cursor, bodies[0])
            if kind != Kind.CONSTRUCTOR:
                children = bodies
        elif function:
            if kind == Kind.VAR_DECL and "constexpr" in self.text(cursor)[:40]:
                return
            if kind == Kind.CASE_STMT:
                children = children[1:]
            self.within(cursor, parent, children)
        for child in children:
            self.walk(child, cursor, function)

    def early_return(self, function, body):
        result, begin = function.result_type.get_canonical(), body.extent.start.offset + 1
        if function.kind in (Kind.FUNCTION_DECL, Kind.CXX_METHOD) and function.spelling != "main" and \
                self.text(body)[:1] == "{" and body.extent.end.line > body.extent.start.line + 3 and \
                result.kind not in (TypeKind.LVALUEREFERENCE, TypeKind.RVALUEREFERENCE, TypeKind.UNEXPOSED):
            value = "" if result.kind == TypeKind.VOID else " {}"
            self.add(function, "return", f"{function.spelling}() returns{value} at once",
                     (begin, begin, f" if (mutant::is_on(@)) return{value}; "))

    def within(self, cursor, parent, children):
        kind = cursor.kind
        if kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.operator(cursor, *children)
        elif kind == Kind.CALL_EXPR and re.fullmatch(r"operator[-+<>=!]+", cursor.spelling) and len(children) == 3:
            self.operator(cursor, children[0], children[2])
        elif kind in (Kind.FLOATING_LITERAL, Kind.INTEGER_LITERAL, Kind.DECL_REF_EXPR):
            self.constant(cursor, parent)
        if kind == Kind.IF_STMT and children and children[0].kind not in (Kind.DECL_STMT, Kind.VAR_DECL) and \
                "constexpr" not in self.text(cursor, end=children[0].extent.start.offset):
            self.condition(children[0])
        if kind == Kind.CONDITIONAL_OPERATOR:
            self.condition(children[0])
        if parent.kind == Kind.COMPOUND_STMT and kind in STATEMENTS:
            end = cursor.extent.end.offset
            # reserving is for speed
            if self.text(cursor, end, end + 1) == ";" and "reserve" not in self.text(cursor):
                self.add(cursor, "statement", f"without {self.text(cursor)[:70]}",
                         (cursor.extent.start.offset, cursor.extent.start.offset,
                          "mutant::is_on(@) ? void() : void("), (end, end, ")"))

    def condition(self, cursor):
        text = self.text(cursor)
        if text and not re.search("[{}#]", text):
            begin, end = cursor.extent.start.offset, cursor.extent.end.offset
            self.add(cursor, "condition", f"!({text[:70]})",
                     (begin, begin, "(mutant::is_on(@) != static_cast<bool>("), (end, end, "))"))

    def operator(self, cursor, first, second):
        between = first.extent.end.offset, second.extent.start.offset
        begin, end = cursor.extent.start.offset, cursor.extent.end.offset
        if begin != first.extent.start.offset or end != second.extent.end.offset or between[0] > between[1]:
            return  # in a macro
        sign, text = self.text(cursor, *between).strip(), self.text(cursor)[:70]
        if sign in ("&&", "||"):
            for operand in (first, second):
                self.condition(operand)
        elif sign in NEGATED:
            # less or equal makes no visible difference for measured numbers
            is_float = {first.type.get_canonical().kind, second.type.get_canonical().kind} & FLOATS
            other, name = (SHIFTED if sign in SHIFTED and not is_float else NEGATED)[sign]
            self.add(cursor, "comparison", f"{text}: {other}", (begin, begin, f"mutant::{name}(@, "),
                     (*between, "," + "\n" * self.text(cursor, *between).count("\n") + " "), (end, end, ")"))
        elif sign in ("+", "-", "+=", "-="):
            added = second.type.get_canonical()
            if added.kind in FLOATS | INTEGERS | {TypeKind.DEPENDENT, TypeKind.VECTOR} or "Eigen::" in added.spelling:
                self.add(cursor, "sign", f"{text}: {sign.translate(str.maketrans('+-', '-+'))}",
                         (between[1], between[1], "mutant::sign(@, "), (end, end, ")"))

    def constant(self, cursor, parent):
        text, kind = self.text(cursor), cursor.type.get_canonical().kind
        if cursor.kind == Kind.DECL_REF_EXPR:
            named = cursor.referenced
            if not named or named.kind != Kind.VAR_DECL or text != cursor.spelling or \
                    named.semantic_parent.kind in FUNCTIONS or "constexpr" not in self.text(named)[:60]:
                return
        elif not re.fullmatch(r"[0-9.][0-9a-zA-Z.'+-]*", text):
            return
        begin, end = cursor.extent.start.offset, cursor.extent.end.offset
        if kind in FLOATS and not re.fullmatch(r"0?\.?0*[fF]?", text):
            factor = "1.1" if len(text) % 2 else ".9"
            changed = f"{text} * {factor}"
        elif kind in INTEGERS and parent.kind in VALUES:
            changed = f"{text} + ({text} < 10 ? 1 : {text} / 10)"
        else:
            return
        told = f"{text}: {'less' if changed.endswith('.9') else 'more'} by a tenth{', at least 1' * (kind in INTEGERS)}"
        self.add(cursor, "constant", told, (begin, begin,
                 f"(mutant::is_on(@) ? std::decay_t<decltype({text})>({changed}) : "), (end, end, ")"))


def main():
    root, database, *folders = sys.argv[1:]
    commands = [shlex.split(entry["command"]) for entry in json.loads(pathlib.Path(database).read_text())
                if os.path.relpath(entry["file"], root).startswith(tuple(folders))]
    with concurrent.futures.ProcessPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        lists = pool.map(places_in, [root] * len(commands), commands, [tuple(folders)] * len(commands))
        found = {(place["file"], place["edits"]): place for places in lists for place in places}
        print(json.dumps(list(found.values())))


if __name__ == "__main__":
    main()
