# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how fast the core is, beside plain ways to do the same, and how true drawings are: ./bench --help."""

import argparse
import os
import sys

from environment.files import put_file
from environment.messages import Failure, run_main
from measures import core_times, drawing_truth
from product.models import check_mesh

ABOUT = """\
./bench prints a table of the times of redraws and of what is computed once, beside plain methods that do less, and of the
plugins in MeshLab if it is installed, with Xvfb: ten minutes. MESH is a PLY or OBJ file, also gzipped. Without one, the
table has the Stanford dragon, which is fetched (--quick: with a quarter of its triangles), and again with 4 and 16 times
as many triangles; and the bunny and igea, where files of these names lie in ../shared/models. With no network, a torus of
our own. Nothing else should run on the machine.

./bench --truth [OPTION VALUE]... [PART...] holds measured drawings against exact hidden lines of CAD parts, which are made
at the first time by OpenCASCADE, in a Python environment in the cache: an hour; with a PART, such as knob, or --deflection
0.1/0.3, or --from TEXT (in the names of directions, as 0-0 or "by 1e-6"), a minute. --pictures FOLDER takes a picture of
each disagreement.

./bench --silhouettes [OPTION VALUE]... [MESH...] holds measured drawings of meshes of every kind against what they cover of
a picture: ten minutes. --only TEXT: meshes with this in their names; --from NAME: a direction, as --+ or 23,31; --pictures
FOLDER as above.
"""


def parse(words):
    parser = argparse.ArgumentParser("./bench", description=ABOUT, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="*", metavar="MESH")
    parser.add_argument("--json", default="", metavar="FILE", help="takes all figures")
    parser.add_argument("--quick", action="store_true", help="one minute, without MeshLab")
    parser.add_argument("--busy", action="store_true", help="the main figures beside a process that streams memory and with "
                        "other processors busy, in turns with those with nothing else on the machine: a minute or two; without MESH "
                        "also pictures and drawings of the dragon, with 16 times its triangles, too, and what lines add to a "
                        "frame in MeshLab: half an hour")
    return parser.parse_intermixed_args(words)


def write_json(text, file):
    if file:
        put_file(text.encode(), file)


def make_table(meshes, file, quick):
    options = ["--precompute", *(["--seconds", "5"] if quick else [])]
    if not meshes:
        meshes = core_times.table_models("bunny", "igea", "dragon_res2", *([] if quick else ["dragon"]))
        options += [] if quick else ["--subdivide", "2"]
    core = core_times.measure(core_times.build_benchmarks("extraction_table"), *options, *meshes)
    in_meshlab = "null" if quick else core_times.measure_in_meshlab(meshes[-1])
    write_json(f'{{"commit": "{core_times.commit()}",\n"core": {core},\n"in_meshlab": {in_meshlab}}}\n', file)


def main():
    words = sys.argv[1:]
    if words[:1] == ["--truth"]:
        return drawing_truth.compare_with_parts(words[1:])
    if words[:1] == ["--silhouettes"]:
        return drawing_truth.compare_with_silhouettes(words[1:])
    options = parse(words)
    for mesh in options.mesh:
        check_mesh(mesh)
    folder = os.path.dirname(options.json) or "."
    if options.json and (os.path.isdir(options.json) or
                         not os.access(options.json if os.path.exists(options.json) else folder, os.W_OK)):
        raise Failure(f"cannot write {options.json}")
    if options.busy:
        if not options.mesh:
            return write_json(core_times.measure_busy(core_times.table_models("bunny", "igea", "dragon")), options.json)
        return write_json(core_times.measure(core_times.build_benchmarks("busy_table"), *options.mesh), options.json)
    return make_table(options.mesh, options.json, options.quick)


run_main(main)
