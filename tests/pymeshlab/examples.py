# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples write pictures of a mesh without a display, and say in a sentence what they cannot do."""

import os
import subprocess
import sys

import matplotlib.image
import numpy
from harness import EXAMPLES, MESH, work_folder

WORK = work_folder("examples")
NO_DISPLAY = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}


def run(example, *arguments):
    return subprocess.run([sys.executable, "-B", EXAMPLES / example, *arguments], cwd=WORK, env=NO_DISPLAY,
                          capture_output=True, text=True)


def picture_of(example, *more):
    """The pixels, 0 to 1, of what the example makes of MESH."""
    file = WORK / f"{example}.png"
    file.unlink(missing_ok=True)
    done = run(example, MESH, file, *more)
    assert done.returncode == 0, done.stderr
    assert f"written: {file}" in done.stdout
    return matplotlib.image.imread(file)[:, :, :3]


def expect_refusal(words, example, *arguments):
    done = run(example, *arguments)
    assert done.returncode == 1, f"{example} ended with {done.returncode}"
    assert words in done.stderr and "Traceback" not in done.stderr, done.stderr


pixels = picture_of("plot_laplacian.py")
height, width, _ = pixels.shape
assert (width, height) == (1440, 720)
# the left half has the torus, seen from above, and the bar: many colours, and the paper around them
view = pixels[: int(0.8 * height), : width // 2]
coloured = view.max(axis=2) - view.min(axis=2) > 0.1
print(f"{coloured.mean():.2%} of the view is coloured")
assert 0.1 < coloured.mean() < 0.7
assert len(numpy.unique((view[coloured] * 255).round(), axis=0)) > 100

front, left = picture_of("draw_lines.py"), picture_of("draw_lines.py", "Left")
for pixels in (front, left):
    ink = (pixels < 0.5).all(axis=2)
    print(f"{ink.mean():.2%} of {pixels.shape} is ink")
    assert 0.01 < ink.mean() < 0.3
    # lines reach all four sides, but for the margin
    rows, columns = numpy.nonzero(ink.any(axis=1))[0], numpy.nonzero(ink.any(axis=0))[0]
    assert rows[0] + columns[0] < 0.2 * max(pixels.shape) and columns[-1] > 0.9 * pixels.shape[1]
# the torus lies in the plane that is seen from the front
assert abs(front.shape[0] / front.shape[1] - 1) < 0.2 and left.shape[0] > 2 * left.shape[1]
(WORK / "lines.svg").unlink(missing_ok=True)
assert run("draw_lines.py", MESH, "lines.svg").returncode == 0 and "<svg" in (WORK / "lines.svg").read_text()

for example in ("plot_laplacian.py", "draw_lines.py"):
    expect_refusal(f"usage: {example} MESH", example)
    expect_refusal(f"usage: {example} MESH", example, *["x"] * 4)
    expect_refusal("nowhere.ply cannot be", example, "nowhere.ply")
expect_refusal("'Front'", "draw_lines.py", MESH, "lines.png", "Sideways")
expect_refusal("cannot be drawn", "draw_lines.py", MESH, "no/folder/lines.png")
