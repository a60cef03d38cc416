# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the plugin for PyMeshLab is: beside the package, or where LAPLACIAN_LINES_PLUGIN says."""

import os
import pathlib

_BESIDE = pathlib.Path(__file__).resolve().parents[1] / "libfilter_laplacian_lines.so"
PLUGIN = pathlib.Path(os.environ.get("LAPLACIAN_LINES_PLUGIN") or _BESIDE)
