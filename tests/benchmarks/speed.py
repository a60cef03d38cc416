#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""./bench times everything once, on a small torus; the build is in $LAPLACIAN_LINES_BUILD."""

import json
import pathlib
import subprocess
import sys
import tempfile

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(CHECKOUT / "scripts"))
from product.models import bumpy_torus

EXPECTED = {"field", "derivatives", "extractor", "view_on_paper", "view_at_rest", "redraw/default",
            "redraw/default_all_threads", "redraw/laplacian_lines", "redraw/contours", "redraw/ridges", "redraw/all_kinds", "redraw/plain_contours"}

with tempfile.TemporaryDirectory() as folder:
    torus, report = pathlib.Path(folder, "torus.ply"), pathlib.Path(folder, "report.json")
    torus.write_text(bumpy_torus(40, 20))
    subprocess.run([CHECKOUT / "bench", torus, "--benchmark_repetitions=1", "--benchmark_min_time=0.001",
                    "--benchmark_report_aggregates_only=false", f"--benchmark_out={report}"], check=True)
    times = {row["run_name"].split("/process_time")[0]: row["real_time"] for row in json.loads(report.read_text())["benchmarks"]}
    assert all(time > 0 for time in times.values()) and EXPECTED <= set(times), times
