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
from environment.releases import SUITES

VERSION = "2025.7"
MESHLAB, HOST = "2025.07", "2025"  # what it is made of, by its number and the host that has the same
BUILD = CHECKOUT / "build/pymeshlab"


def ensure_meshlab_headers():
    """Sets MESHLAB_SOURCE_DIR."""
    folder = cache_folder() / "headers" / MESHLAB
    os.environ["MESHLAB_SOURCE_DIR"] = str(folder)
    if not (folder / "src/common").is_dir():
        say(f"fetching the headers of MeshLab {MESHLAB} from the source package of Debian {SUITES[HOST]}")
        if (not publish_into(folder, lambda scratch: unpack_source("meshlab", scratch, SUITES[HOST])) or
                (folder / "ML_VERSION").read_text().strip() != MESHLAB):
            shutil.rmtree(folder, ignore_errors=True)
            raise Obstacle(f"the source of MeshLab {MESHLAB} could not be fetched; unpack it yourself to {folder}")


def ensure_pymeshlab():
    """Its Python, whose MeshLab's headers are there. Sets MESHLAB_SOURCE_DIR."""
    python = ensure_python("pymeshlab", VERSION, "0.5 GB", f"pymeshlab=={VERSION}", "numpy", "matplotlib")
    ensure_meshlab_headers()
    return python


def build_for_pymeshlab(python, target):
    """In build/pymeshlab."""
    package = output(python, "-c", "import importlib.util as u; print(u.find_spec('pymeshlab').submodule_search_locations[0])")
    if not package:
        raise Failure(f"{python} has no PyMeshLab")
    os.environ["LAPLACIAN_LINES_BUILD"] = str(BUILD)
    packages.ensure_packages(*packages.BUILD, *packages.TEST)
    say(f"building the filter for PyMeshLab {VERSION}")
    build_targets(target, preset="pymeshlab", options=[
        f"-DMESHLAB_COMMON_LIBRARY={package}/lib/libmeshlab-common.so", f"-DLAPLACIAN_LINES_PYTHON={python}"])


def run_python(words):
    """Python with PyMeshLab and the module laplacian_lines."""
    try:
        python = ensure_pymeshlab()
    except Obstacle as reason:
        raise Failure(reason) from None
    build = os.environ.get("LAPLACIAN_LINES_BUILD")
    build_for_pymeshlab(python, "filter_laplacian_lines")
    environment = {**os.environ, "PYTHONPATH": ":".join(filter(None,
                                                               (str(BUILD / "python"), os.environ.get("PYTHONPATH"))))}
    environment.pop("LAPLACIAN_LINES_BUILD")
    return run([python, *words], interactive=True,
               env={**environment, **({"LAPLACIAN_LINES_BUILD": build} if build else {})})
