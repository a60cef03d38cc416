#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""table.py PROGRAM BUSY_PROGRAM, with the build in $LAPLACIAN_LINES_BUILD: ./bench's table and its JSON, of a small
mesh, and the table beside other work. The program fails by itself when the extractor and the plain loops find zeros of different length."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

REDRAWS = "lines default_style plain_contours plain_laplacian read_plain_mesh read_extractor"
FIGURES = {
    "extraction_ms": REDRAWS,
    "extraction_median_ms": REDRAWS,
    "building_s": "field laplacian extractor",
    "memory": "extractor field",
    "ratios": "lines_to_contours lines_to_reading",
    "counts": "rounds lines segments",
}
RINGS, SIDES = 60, 30


def write_bumpy_torus(file):
    lines = ["OFF", f"{RINGS * SIDES} {2 * RINGS * SIDES} 0"]
    for i in range(RINGS * SIDES):
        u, v = 2 * math.pi * (i // SIDES) / RINGS, 2 * math.pi * (i % SIDES) / SIDES
        r = 0.4 + 0.04 * math.sin(9 * u) * math.sin(4 * v)
        ring = 1 + r * math.cos(v)
        lines.append(f"{ring * math.cos(u)} {ring * math.sin(u)} {r * math.sin(v)}")
    for i in range(RINGS):
        for j in range(SIDES):
            a, b, c, d = (k % RINGS * SIDES + m % SIDES for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            lines += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
    file.write_text("\n".join(lines) + "\n")


def run(*words, code=0):
    """What it prints; its errors, if it has to fail."""
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE if code else None, text=True)
    assert done.returncode == code, f"{words} ends with {done.returncode}"
    return done.stderr if code else done.stdout


def expect_rows(table, *rows):
    for row in rows:
        assert re.search(f"^{row}$", table, re.M), f"there is no row {row} in\n{table}"


with tempfile.TemporaryDirectory() as folder:
    bench, program = pathlib.Path(__file__).resolve().parents[2] / "bench", sys.argv[1]
    torus, file = pathlib.Path(folder, "torus.off"), pathlib.Path(folder, "report.json")
    write_bumpy_torus(torus)
    table = run(bench, "--quick", "--json", file, torus)
    expect_rows(table, "Commit .*", r"\| triangles \| 3,600 \|", r"\| plain contours, not traced \| [0-9.]+ \|")
    report = json.loads(file.read_text())
    assert report["commit"] and report["in_meshlab"] is None and report["core"]["machine"]["processors"] > 0
    assert report["core"]["compiler"] and report["core"]["machine"]["processor"]
    (mesh,) = report["core"]["meshes"]
    for section, keys in FIGURES.items():
        for key in keys.split():
            assert mesh[section][key] > 0, f"{section} {key}"
    table = run(program, "--rounds", "1", "--subdivide", "1", torus)
    expect_rows(table, r"\| triangles \| 3,600 \| 14,400 \|", r"\| plain contours \| – \| [-0-9.]+ \|")
    assert "--rounds needs a number, at least 1" in run(program, "--rounds", "0", torus, code=2)

    busy = run(sys.argv[2], "--rounds", "1", torus)
    columns = "".join(rf" \| torus, {load}" for load in ("quiet", "memory streamed", "other cores busy", "all cores busy"))
    expect_rows(busy, rf"\|{columns} \|", *(rf"\| {row}( \| [0-9.]+){{4}} \|" for row in (
        "the field, all threads", "plain contours, not traced", "Laplacian lines and contours : plain contours")))
