# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab 2020.09 aborts at a filter script that lacks a parameter of a filter: ours get their defaults, which the
examples have."""

from xml.etree import ElementTree

from environment.build import CHECKOUT
from environment.messages import say


def complete(script, copy):
    """The name of the script, or of a copy that has what it lacks."""
    try:
        root = ElementTree.parse(script).getroot()
    except (OSError, ElementTree.ParseError):
        return script  # for MeshLab to refuse
    examples = {example.get("name"): example for file in (CHECKOUT / "docs/examples").glob("*.mlx")
                for example in ElementTree.parse(file).iter("filter")}
    lacking = [add_missing(step, examples.get(step.get("name"), ())) for step in root.iter("filter")]
    if not any(lacking):
        return script
    say(f"{script}: these parameters have their defaults: {', '.join(sum(lacking, []))}")
    copy.write_bytes(b"<!DOCTYPE FilterScript>\n" + ElementTree.tostring(root))
    return str(copy)


def add_missing(step, example):
    """The names of what is added."""
    given = {parameter.get("name") for parameter in step}
    missing = [parameter for parameter in example if parameter.get("name") not in given]
    step.extend(missing)
    return [parameter.get("name") for parameter in missing]
