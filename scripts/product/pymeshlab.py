# SPDX-License-Identifier: GPL-3.0-or-later
"""PyMeshLab as a host of the filter plugin: a Python environment in the cache folder, and a build for the MeshLab that
its package holds, which is of double precision and no other one's. What cannot be had raises Obstacle."""

import os
import shutil

from environment import packages
from environment.build import CHECKOUT, build_targets
from environment.files import cache_folder, publish_into
from environment.headers import unpack_source
from environment.messages import Failure, Obstacle, output, run, say
from environment.python_environments import ensure_python

VERSION, MESHLAB = "2025.7", "2025.07"
SUITE = "forky"  # the release of Debian that packages the same MeshLab
BUILD = CHECKOUT / "build/pymeshlab"
MODULES = "import numpy, pymeshlab, nanobind, sysconfig as s; print(pymeshlab.__path__[0], nanobind.cmake_dir(), s.get_path('include'))"


def ensure_meshlab_headers():
    """Sets MESHLAB_SOURCE_DIR."""
    folder = cache_folder() / "headers" / MESHLAB
    os.environ["MESHLAB_SOURCE_DIR"] = str(folder)
    if not (folder / "src/common").is_dir():
        say(f"fetching the headers of MeshLab {MESHLAB} from the source package of Debian {SUITE}")
        if (not publish_into(folder, lambda scratch: unpack_source("meshlab", scratch, SUITE)) or
                (folder / "ML_VERSION").read_text().strip() != MESHLAB):
            shutil.rmtree(folder, ignore_errors=True)
            raise Obstacle(f"the source of MeshLab {MESHLAB} could not be fetched; unpack it yourself to {folder}")


def ensure_pymeshlab():
    """Its Python, with what the module for Python is compiled with."""
    return ensure_python("pymeshlab", f"{VERSION}-1", "0.5 GB", f"pymeshlab=={VERSION}", "numpy", "matplotlib",
                         "nanobind>=3.1,<4", "nanobind-backend>=1.0,<2")


def build_for_pymeshlab(*targets, extra_packages=()):
    """In build/pymeshlab, whose folder "python" then holds the plugin and the package. Returns the Python."""
    python = ensure_pymeshlab()
    package, nanobind, headers = (output(python, "-c", MODULES) or "- - -").split()
    if package == "-":
        raise Failure(f"{python} has no PyMeshLab")
    packages.ensure_packages(*packages.BUILD, *extra_packages)
    if not os.path.exists(f"{headers}/Python.h"):
        packages.ensure_packages("python3-dev")
    ensure_meshlab_headers()
    try:
        say(f"building the filters for PyMeshLab {VERSION}")
        build_targets(*targets, preset="pymeshlab", build=BUILD, options=[
            f"-DMESHLAB_COMMON_LIBRARY={package}/lib/libmeshlab-common.so", f"-Dnanobind_DIR={nanobind}",
            f"-DPython_EXECUTABLE={python}"])
    finally:
        del os.environ["MESHLAB_SOURCE_DIR"]
    return python


def run_python(words):
    """Python with PyMeshLab and the module laplacian_lines."""
    python = build_for_pymeshlab("filter_laplacian_lines", "_core")
    path = [str(BUILD / "python"), *filter(None, [os.environ.get("PYTHONPATH")])]
    return run([python, *words], interactive=True, env={**os.environ, "PYTHONPATH": ":".join(path)})


def run_server(words):
    """meshlabserver's words."""
    return run_python(["-B", CHECKOUT / "programs/python/mesh_server.py", BUILD / "python/libfilter_laplacian_lines.so", *words])
