# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings against what has to be seen: exact lines of CAD parts, and silhouettes of meshes of every kind."""

import hashlib

from environment.build import CHECKOUT, build_folder, build_targets
from environment.files import cache_folder
from environment.messages import Failure, Obstacle, run, say
from environment.python_environments import ensure_python
from product.models import dragon_file, is_there, model_beside

TOOLS = ("cadquery==2.5.2",)
SCANS = ("bunny", "igea", "armadillo")
TRUTH = CHECKOUT / "programs/benchmarks/truth"


def part_files(names):
    """These parts, or all; made the first time, in some minutes."""
    recipe = "".join(file.read_text() for file in sorted(TRUTH.glob("*.py"))) + " ".join(TOOLS)
    folder = cache_folder() / "cad_parts" / hashlib.sha256(recipe.encode()).hexdigest()[:12]
    try:
        python = ensure_python("exact_lines", 1, "1 GB", *TOOLS)
    except Obstacle as reason:
        raise Failure(reason) from None
    say(f"making the missing parts and their exact lines in {folder}")
    if run([python, "-B", TRUTH / "make_parts.py", folder, *names], stdout=2) != 0:
        raise Failure("the parts could not be made")
    return [folder / f"{name}.part" for name in names] or sorted(folder.glob("*.part"))


def split(words):
    """Options, which have a value each, and names."""
    options, names = [], []
    while words:
        if words[0].startswith("-"):
            if len(words) < 2:
                raise Failure(f"{words[0]} needs a value; see ./bench --help")
            options += words[:2]
            words = words[2:]
        else:
            names.append(words[0])
            words = words[1:]
    return options, names


def build_truth():
    """The folder of the two programs."""
    build_targets("drawing_truth", "drawing_silhouettes", preset="benchmarks", extra_packages=())
    return build_folder() / "programs/benchmarks/truth"


def compare_with_parts(words):
    options, names = split(words)
    program = build_truth() / "drawing_truth"
    return run([program, "--left-out", TRUTH / "left_out.tsv", *options, *part_files(names)])


def compare_with_silhouettes(words):
    """`names` are scans; default: those beside the checkout, and the dragon if it was fetched."""
    options, names = split(words)
    program = build_truth() / "drawing_silhouettes"
    if not names:
        names = [mesh for name in SCANS if (mesh := model_beside(CHECKOUT,
                                                                 name))] + [dragon_file()] * is_there(dragon_file())
    return run([program, *options, *names])
