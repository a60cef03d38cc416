# SPDX-License-Identifier: GPL-3.0-or-later
"""PyMeshLab as a host of the filter plugin: a Python environment in the cache folder, and a build for the MeshLab that
its package holds, which is of double precision and no other one's. What is not available raises Unavailable."""

import os

from environment import packages
from environment.build import CHECKOUT, build_targets
from environment.headers import ensure_headers
from environment.messages import Failure, output, run, say
from environment.python_environments import ensure_python

VERSION, MESHLAB = "2025.7", "2025.07"
SUITE = "forky"  # the release of Debian that packages the same MeshLab
BUILD = CHECKOUT / "build/pymeshlab"
MODULES = "import numpy, pymeshlab, nanobind, sysconfig as s; print(pymeshlab.__path__[0], nanobind.cmake_dir(), s.get_path('include'))"


def build_for_pymeshlab(*targets, extra_packages=()):
    """In build/pymeshlab, whose folder "python" then holds the plugin and the package. Returns PyMeshLab's Python."""
    python = ensure_python("pymeshlab", f"{VERSION}-1", "0.5 GB", f"pymeshlab=={VERSION}", "numpy", "matplotlib",
                           "nanobind>=3.1,<4", "nanobind-backend>=1.0,<2")
    package, nanobind, include = (output(python, "-c", MODULES) or "- - -").split()
    if package == "-":
        raise Failure(f"{python} has no PyMeshLab")
    packages.ensure_packages(*packages.BUILD, *extra_packages)
    if not os.path.exists(f"{include}/Python.h"):
        packages.ensure_packages("python3-dev")
    headers = ensure_headers(MESHLAB, SUITE)
    say(f"building the filters for PyMeshLab {VERSION}")
    build_targets(*targets, preset="pymeshlab", build=BUILD, options=[
        f"-DMESHLAB_SOURCE_DIR={headers}", f"-DMESHLAB_COMMON_LIBRARY={package}/lib/libmeshlab-common.so",
        f"-Dnanobind_DIR={nanobind}", f"-DPython_EXECUTABLE={python}"])
    return python


def run_python(words):
    """Python with PyMeshLab and the module laplacian_lines."""
    python = build_for_pymeshlab("filter_laplacian_lines", "_core")
    path = [str(BUILD / "python"), *filter(None, [os.environ.get("PYTHONPATH")])]
    return run([python, *words], interactive=True, env={**os.environ, "PYTHONPATH": ":".join(path)})


def run_server(words):
    """meshlabserver's words."""
    return run_python(["-B", CHECKOUT / "programs/python/mesh_server.py", BUILD / "python/libfilter_laplacian_lines.so", *words])
