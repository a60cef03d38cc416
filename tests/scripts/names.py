# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts in Python name nothing that is not there, and those in scripts/ import nothing that they do not use."""
import ast
import builtins

from harness import *


def names_of(tree):
    """Those that are imported, those that are bound in any way, and those that are read."""
    imported, bound, read, stars = {}, set(dir(builtins)) | {"__file__"}, set(), False
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for alias in node.names:
                stars |= alias.name == "*"
                imported[(alias.asname or alias.name).split(".")[0]] = node.lineno
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            bound.add(node.name)
        elif isinstance(node, ast.arg):
            bound.add(node.arg)
        elif isinstance(node, ast.ExceptHandler) and node.name:
            bound.add(node.name)
        elif isinstance(node, ast.Name):
            (read if isinstance(node.ctx, ast.Load) else bound).add(node.id)
    return imported, bound, read, stars


class Names(ScriptTest):
    def test_names(self):
        files = [file for folder in ("scripts", "tests") for file in sorted((CHECKOUT / folder).rglob("*.py"))]
        self.assertGreater(len(files), 50)
        complaints = []
        for file in files:
            imported, bound, read, stars = names_of(ast.parse(file.read_text()))
            if not stars:
                complaints += [f"{file}: there is no {name}" for name in sorted(read - bound - set(imported))]
            if SCRIPTS in file.parents:
                complaints += [f"{file}:{line}: {name} is not used" for name,
                               line in imported.items() if name not in read | {"*"}]
        self.assertFalse(complaints, "\n".join(complaints))


unittest.main()
