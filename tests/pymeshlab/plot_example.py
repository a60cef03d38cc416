# SPDX-License-Identifier: GPL-3.0-or-later
"""The example that plots |Δn| writes a picture of the mesh."""

import subprocess
import sys

import matplotlib.image
import numpy
from harness import EXAMPLES, MESH, work_folder

picture = work_folder("plot") / "torus.png"
picture.unlink(missing_ok=True)
subprocess.run([sys.executable, "-B", EXAMPLES / "plot_laplacian.py", MESH, picture], check=True)

pixels = matplotlib.image.imread(picture)[:, :, :3]
height, width, _ = pixels.shape
assert (width, height) == (1440, 720)
# the left half has the torus, seen from above, and the bar: many colours, and the paper around them
view = pixels[: int(0.8 * height), : width // 2]
coloured = view.max(axis=2) - view.min(axis=2) > 0.1
print(f"{coloured.mean():.2%} of the view is coloured")
assert 0.1 < coloured.mean() < 0.7
assert len(numpy.unique((view[coloured] * 255).round(), axis=0)) > 100
