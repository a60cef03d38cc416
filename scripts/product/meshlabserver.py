# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --server: MeshLab 2020.09's own meshlabserver, whose failures are reported; later ones have none, and PyMeshLab runs
the scripts."""

import contextlib
import os
from xml.etree import ElementTree

from environment import packages
from environment.build import CHECKOUT
from environment.messages import run, say
from product.display import display


def run_server(stage, words, folder):
    """MeshLab's own needs an X display with OpenGL even for filters."""
    words = [complete(word, folder / f"{number}.mlx") if words[number - 1:number] == ["-s"] else word
             for number, word in enumerate(words)]
    begun = folder / "begun"
    begun.touch()
    with contextlib.ExitStack() as shown:
        if not os.environ.get("DISPLAY"):
            packages.ensure_packages(*packages.DISPLAY)
            shown.enter_context(display(1280, 900))
        code = run([stage / "bin/meshlabserver", *words])
    if 128 < code < 192:  # a signal; 255 is meshlabserver's own
        say("meshlabserver has crashed, mostly in its own reader of a damaged mesh")
    # it ends with 0 even if it cannot write
    missing = [name for option, name in zip(words, words[1:]) if option == "-o" and not is_newer(name, begun)]
    for name in missing:
        say(f"{name} was not written")
    return code or int(bool(missing))


def is_newer(name, begun):
    return os.path.exists(name) and os.stat(name).st_mtime_ns > begun.stat().st_mtime_ns


def complete(script, copy):
    """The name of the script, or of a copy that has what it lacks: meshlabserver aborts at a filter without all of its
    parameters. Ours get their defaults, which the examples have."""
    try:
        root = ElementTree.parse(script).getroot()
    except (OSError, ElementTree.ParseError):
        return script  # for MeshLab to refuse
    examples = {example.get("name"): example for file in (CHECKOUT / "docs/examples").glob("*.mlx")
                for example in ElementTree.parse(file).iter("filter")}
    added = []
    for step in root.iter("filter"):
        given = {parameter.get("name") for parameter in step}
        missing = [parameter for parameter in examples.get(step.get("name"), ()) if parameter.get("name") not in given]
        step.extend(missing)
        added += [parameter.get("name") for parameter in missing]
    if not added:
        return script
    say(f"{script}: these parameters have their defaults: {', '.join(added)}")
    copy.write_bytes(b"<!DOCTYPE FilterScript>\n" + ElementTree.tostring(root))
    return str(copy)
