# SPDX-License-Identifier: GPL-3.0-or-later
"""The example plots a mesh without a display, and says in a sentence what it cannot do."""

import os
import pathlib
import subprocess
import sys

import matplotlib.image

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "docs/examples/plot_laplacian.py"
TESTING = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"], "Testing")
MESH, FILE = TESTING / "reference/torus.ply", TESTING / "laplacian.png"
os.environ.pop("DISPLAY", None)


def run(*arguments):
    return subprocess.run([sys.executable, "-B", EXAMPLE, *arguments], capture_output=True, text=True)


FILE.unlink(missing_ok=True)
done = run(MESH, FILE)
assert done.returncode == 0 and f"written: {FILE}" in done.stdout, done.stderr
pixels = matplotlib.image.imread(FILE)[:, :, :3]
assert pixels.shape == (720, 720, 3)
# the torus, seen from above, over the bar: many colours, and the paper around them
view = pixels[:576]
coloured = view.max(axis=2) - view.min(axis=2) > 0.1
assert 0.1 < coloured.mean() < 0.7, coloured.mean()
for words, arguments in (("usage: plot_laplacian.py MESH", []), ("nowhere.ply cannot be plotted", ["nowhere.ply", FILE])):
    done = run(*arguments)
    assert done.returncode == 1 and words in done.stderr and "Traceback" not in done.stderr, done.stderr
