#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the plugins cost inside MeshLab, in a view of 1000 x 700 without a display, as JSON:
  programs/benchmarks/in_meshlab.py [MESH], the Stanford dragon if none is named
  filter       Compute Laplacian Lines with its defaults, in all, as MeshLab's log has it
  switch_on    Laplacian Lines switched on after it: the lines made ready, and the plugin's part of the first redraw
  extract, upload, draw_calls   the plugin's part of a redraw, medians of all directions around the mesh: finding the lines, handing
               them to OpenGL, and telling it what to draw, with all that remains
  drawing      OpenGL's part, here by software: the call that draws, which shades the points before it returns, and waiting for the end
  dragging, at_rest   what lines add to a frame, from the redraw to OpenGL's end: medians of frames with lines less those without, in
               turns; by the clock, and in processor time of MeshLab's thread and of all, which other work changes less
"""

import json
import pathlib
import re
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True  # files beside the sources have them look changed
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from environment import packages
from environment.build import build_folder, build_targets
from environment.messages import Failure, run_main
from product.display import display, private_home
from product.meshlab import explain_failure, run_meshlab
from product.models import prepare_mesh
from product.stage import built_plugins, stage_meshlab

REDRAWS = 48
TURNS = 6
FRAMES = 16  # with lines and without, in each turn


def median(text, what):
    """Of the numbers before "ms" or "s" in the boxes of all redraws, with a point as decimals have here."""
    values = re.findall(rf"{what} ([0-9.]+) m?s", text)
    if not values:
        raise Failure(f"MeshLab's view does not show: {what}")
    return float(statistics.median_low(map(float, values)))


def timed_frames(lines, work):
    """Commands that time frames with lines, "on", or without, "off"."""
    moves = [f"time {work}/dragging_{lines} move {0.3 + 0.02 * i:.2f} {0.4 + 0.01 * i:.2f}" for i in range(FRAMES)]
    return [f"check Laplacian Lines {lines}",
            " ; ".join(["together press 0.3 0.4", *moves, "release 0.62 0.56"]),
            " ; ".join(["together redraw"] + [f"time {work}/at_rest_{lines} redraw"] * FRAMES)]


def added(what, work):
    """Milliseconds, by what they are of, from the columns that the command time writes."""
    medians = []
    for lines in ("on", "off"):
        rows = [map(float, row.split()) for row in (work / f"{what}_{lines}").read_text().splitlines()]
        medians.append([statistics.median(column) for column in zip(*rows)])
    clocks = ("ms", "on_meshlabs_thread_ms", "on_all_threads_ms")
    return {f"{what}_{clock}": round(on - off, 1) for clock, on, off in zip(clocks, *medians)}


def main():
    build = build_folder()
    build_targets("meshlab_plugins", preset="window", extra_packages=packages.DISPLAY)
    stage_meshlab(build / "stage", built_plugins(build, "plugins", "driver"))
    with tempfile.TemporaryDirectory() as name, display(1700, 1000):
        work = pathlib.Path(name)
        mesh = prepare_mesh("".join(sys.argv[1:2]), work)
        environment = {**private_home(work / "home"), "LIBGL_ALWAYS_SOFTWARE": "1", "LAPLACIAN_LINES_PROBE": "1"}
        code = run_meshlab(build / "stage", work, [
            "time-limit 600", "wait", f"open {mesh}", "size 1000x700", "trigger Compute Laplacian Lines", "apply",
            "close",
            f"log {work}/messages", "check Laplacian Lines on", "check Laplacian Lines Probe on",
            "setdeco Show Statistics = on",
            f"turn {REDRAWS} 15 {work}/redraws",
            "setdeco Show Statistics = off", "check Laplacian Lines Probe off",
            *(command for _ in range(TURNS) for lines in ("on", "off") for command in timed_frames(lines, work)),
            "quit"], env=environment)
        if code != 0:
            raise Failure(f"MeshLab ended with an error: {explain_failure(work, code)}")
        filters = re.findall(r"Applied filter Compute Laplacian Lines in (\d+) msec", (work / "messages").read_text())
        if not filters:
            raise Failure("MeshLab's log does not tell the filter's time")
        boxes = (work / "redraws").read_text()
        frames = {**added("dragging", work), **added("at_rest", work)}
    print(json.dumps({"filter_s": int(filters[-1]) / 1000, "switch_on_s": median(boxes, "switched on in"),
                      "extract_ms": median(boxes, "extraction"), "upload_ms": median(boxes, "upload"),
                      "draw_calls_ms": median(boxes, "draw calls"), "drawing_ms": median(boxes, "drawing by OpenGL"),
                      **frames}))


run_main(main)
