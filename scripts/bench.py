# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how fast the core is, and how accurate drawings are: ./bench --help."""

import tempfile

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import output, run, run_main
from environment.options import Parser
from product.models import check_mesh, prepare_mesh

ABOUT = """\
./bench [MESH] times what is computed once a mesh, redraws of each kind of lines and a drawing on paper, and a simple loop
for comparison: of MESH, a PLY, STL, OBJ or OFF file, also gzipped, or of the Stanford dragon, which is fetched.
Options of Google Benchmark go on to it, such as --benchmark_filter=redraw or --benchmark_out=FILE.json; it takes
medians of five repetitions in random order. Nothing else should run on the machine. LAPLACIAN_LINES_THREADS=1 and
LAPLACIAN_LINES_VECTOR_BYTES=16 or 32 in the environment have it use fewer threads and lesser instructions.

./bench --truth [PART...] compares measured drawings of CAD parts with their exact visible lines and with the silhouettes of
their meshes, in ten seconds; ./test drawing_truth has the limits.
"""
MEDIANS = ["--benchmark_repetitions=5", "--benchmark_enable_random_interleaving", "--benchmark_min_time=0.2",
           "--benchmark_report_aggregates_only"]


def truth(options):
    packages.ensure_packages(*packages.CORE)
    build_targets("drawing_truth", preset="benchmarks")
    folder = CHECKOUT / "programs/benchmarks/truth/parts"
    parts = [folder / f"{name}.part" for name in options.names] or sorted(folder.glob("*.part"))
    pictures = ["--pictures", options.pictures] if options.pictures else []
    return run([build_folder() / "programs/benchmarks/truth/drawing_truth", *pictures, *parts])


def speed(names, others):
    for mesh in names:
        check_mesh(mesh)
    packages.ensure_packages(*packages.CORE, "libbenchmark-dev")
    build_targets("speed", preset="benchmarks")
    commit = output("git", "-C", CHECKOUT, "describe", "--always", "--dirty", "--abbrev=12") or "unknown"
    with tempfile.TemporaryDirectory() as work:
        mesh = prepare_mesh(*names or [""], work)
        return run([build_folder() / "programs/benchmarks/speed", *MEDIANS, f"--benchmark_context=commit={commit}", *others, mesh])


def main():
    parser = Parser("./bench", description=ABOUT)
    parser.add_argument("names", nargs="*", metavar="MESH|PART", help="a part's name, such as knob")
    parser.add_argument("--truth", action="store_true", help="measures drawings, not times")
    parser.add_argument("--pictures", metavar="FOLDER", help="with --truth: gets SVG files of what is missed or wrong")
    options, others = parser.parse_known_args()
    unknown = [word for word in others if not word.startswith("--benchmark_")]
    if options.pictures and not options.truth:
        parser.error("--pictures goes with --truth")
    if unknown or len(options.names) > 1 and not options.truth:
        parser.error(f"not understood: {' '.join(unknown or options.names[1:])}")
    return truth(options) if options.truth else speed(options.names, others)


run_main(main)
