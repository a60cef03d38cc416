# SPDX-License-Identifier: GPL-3.0-or-later
"""A test that is a script of the driver alone: gui.py FILE.gui

"== FUNCTION WORDS..." calls a function of the harness; one that drives MeshLab gets the lines up to the next one, and
words NAME=VALUE as its environment. Among these lines "@FUNCTION WORDS..." stands for what the function returns; or,
after "== let NAME", "@NAME WORDS..." for the lines there, with $1 and so on in them. $WORK and $CHECKOUT are folders. #
begins a comment. "== display WxH" is the size of the screen."""

import inspect
import shlex

import harness

macros = {}


def expanded(lines):
    """As what they stand for."""
    result = []
    for line in lines:
        line = line.replace("$WORK", str(harness.WORK)).replace("$CHECKOUT", str(harness.CHECKOUT))
        if not line.startswith("@"):
            result.append(line)
            continue
        name, *words = shlex.split(line[1:])
        if name not in macros:
            result += getattr(harness, name)(*words).splitlines()
            continue
        body = macros[name]
        for number in range(1, 5):
            body = [text.replace(f"${number}", words[number - 1] if number <= len(words) else "") for text in body]
        result += expanded(body)
    return result


def run_part(command, lines):
    name, *words = shlex.split(command)
    if name == "let":
        macros[words[0]] = lines
    elif name != "display":
        function, script = getattr(harness, name), "\n".join(expanded(lines))
        if "options" in inspect.signature(function).parameters:
            environment = dict(word.split("=", 1) for word in words if word.isupper() or "=" in word)
            function(*(word for word in words if "=" not in word), script, **environment)
        elif name == "ply":
            function(words[0], words[1:], script)
        else:
            function(*words)


text = open(harness.TEST, encoding="utf-8").read()
_, *parts = f"\n{text}".split("\n== ")
sizes = [part.split()[1] for part in parts if part.startswith("display ")]
harness.begin_test(*sizes)
for part in parts:
    command, *body = part.splitlines()
    run_part(command, [line for line in body if not line.startswith("#")])
