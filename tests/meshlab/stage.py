# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets up the MeshLab that the other tests run, with the plugins just built; a build without one of them is still worth
testing."""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from product.stage import built_plugins, stage_meshlab

build = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
stage_meshlab(build / "stage", built_plugins(build, "plugins", "driver"))
