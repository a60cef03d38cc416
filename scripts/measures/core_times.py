# SPDX-License-Identifier: GPL-3.0-or-later
"""Times of the core: the meshes, and building and running of programs/benchmarks."""

import json
import pathlib
import tempfile

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import Failure, output, run, say
from product import models


def build_benchmarks(target, *extra_packages):
    """The program."""
    packages.ensure_packages(*packages.CORE, *extra_packages)
    say(f"building {target}")
    build_targets(target, preset="benchmarks")
    return build_folder() / "programs/benchmarks" / target


def table_models(*names, checkout=CHECKOUT):
    """Those available, or one of our own."""
    found = []
    for name in names:
        is_dragon = name.startswith("dragon")
        mesh = models.stanford_dragon(name[6:]) if is_dragon else models.model_beside(checkout, name)
        if mesh:
            found.append(mesh)
        elif is_dragon:
            say(f"left out: the model {name} cannot be fetched")
    return found or [models.kept_bumpy_torus()]


def commit():
    return output("git", "-C", CHECKOUT, "describe", "--always", "--dirty", "--abbrev=12") or "unknown"


def measure(program, *words):
    """Prints the table; all figures."""
    print(f"Commit {commit()}", flush=True)
    with tempfile.TemporaryDirectory() as work:
        figures = pathlib.Path(work, "figures")
        if run([program, "--json", figures, *words]) != 0:
            raise Failure("the table could not be made")
        return figures.read_text()


def measure_busy(meshes):
    """Prints tables of the main figures under load, and of commands for the last mesh."""
    program, write_mesh = build_benchmarks("busy_table"), build_benchmarks("write_mesh")
    with tempfile.TemporaryDirectory() as work:
        large = f"{work}/large.ply"
        if run([write_mesh, meshes[-1], "--refine", "2", large]) != 0:
            raise Failure("the large mesh could not be made")
        commands = {"./run --picture": f"--picture {work}/picture.png {meshes[-1]}",
                    "six views on paper": f"--drawing {work}/six.pdf --views six --unit m {meshes[-1]}",
                    "the same of 16 times the triangles": f"--drawing {work}/six.pdf --views six --unit m {large}"}
        words = [word for label, words in commands.items()
                 for word in ("--command", f"{label}={CHECKOUT}/run {words} >{work}/log 2>&1")]
        figures = measure(program, *words, *meshes)
    return f'{{"beside other work": {figures},\n"in_meshlab": {measure_in_meshlab(meshes[-1])}}}\n'


def measure_in_meshlab(mesh):
    """Prints a table of the plugins' times; returns the figures, "null" if left out."""
    for package in ("meshlab", "xvfb"):
        if packages.missing([package]):
            say(f"left out: times in MeshLab, for the package {package} is not installed")
            return "null"
    say("measuring in MeshLab")
    figures = output(CHECKOUT / "programs/benchmarks/in_meshlab.py", mesh)
    if figures is None:
        say("left out: times in MeshLab")
        return "null"
    print(f"\n| in MeshLab, {pathlib.Path(mesh).name} | |\n|---|--:|")
    for name, value in json.loads(figures).items():
        what, unit = name.rsplit("_", 1)
        print(f"| {what.replace('_', ' ')}, {unit} | {value} |")
    return figures
