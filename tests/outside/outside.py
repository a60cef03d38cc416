# SPDX-License-Identifier: GPL-3.0-or-later
"""outside.py PROGRAM [WORDS...]: runs judge.py with a Python that has the programs of others that it judges with. It
is skipped where they cannot be had, or is a failure if LAPLACIAN_LINES_REQUIRED is set."""

import os
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scripts"))
from environment.messages import Failure, Unavailable, skip
from environment.python_environments import ensure_python

try:
    if not shutil.which("rsvg-convert"):
        raise Unavailable("there is no rsvg-convert")
    python = ensure_python("outside_tools", 2, "0.4 GB", "numpy==2.4.6", "opencv-python-headless==5.0.0.93",
                           "trimesh==5.2.0", "manifold3d==3.5.4", "rtree==1.4.1", "fast-simplification==0.2.0")
except (Failure, Unavailable) as reason:
    skip(reason)
os.execv(python, [python, "-B", HERE / "judge.py", *sys.argv[1:]])
