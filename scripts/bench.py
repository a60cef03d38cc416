# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how fast the core is, beside plain ways to do the same. See USAGE below."""

import os
import sys

from environment.files import put_file
from environment.messages import Failure, run, run_main
from measures import core_times, drawing_truth
from product.models import check_mesh

USAGE = """\
./bench [--json FILE] [--quick] [MESH...]
                              prints a table of the times of redraws and of what is computed once, beside plain
                              methods that do less, and of the plugins in MeshLab if it is installed, with Xvfb: ten
                              minutes; or with --quick one, without MeshLab. FILE takes all figures
./bench --paper [--json FILE] [MESH...]
                              prints the paper's table: frames a second of each kind of lines against contours alone:
                              two minutes
./bench --busy [--json FILE] [MESH...]
                              prints the main figures beside a process that streams memory, and with all processors but
                              one busy, in turns with those with nothing else on the machine: a minute or two
./bench --instructions [MESH] counts the instructions of redraws and the memory that they read, in valgrind
./bench --steps ARGS...       times single steps of the core by Google Benchmark with ARGS
./bench --truth [OPTION VALUE]... [PART...]
                              holds measured drawings against exact hidden lines of CAD parts, which are made at the
                              first time by OpenCASCADE, in a Python environment in the cache: an hour; with a PART, such
                              as knob, or --deflection 0.1/0.3, or --from TEXT (in the names of directions, as 0-0 or
                              "by 1e-6"), a minute. --pictures FOLDER takes a picture of each disagreement
./bench --silhouettes [OPTION VALUE]... [MESH...]
                              holds measured drawings of meshes of every kind against what they cover of a picture:
                              ten minutes. --only TEXT: meshes with this in their names; --from NAME: a direction,
                              as --+ or 23,31; --pictures FOLDER as above

MESH is a PLY or OBJ file, also gzipped. Without one, the table has the Stanford dragon, which is fetched (--quick: with
a quarter of its triangles), and again with 4 and 16 times as many triangles; and the bunny and igea, where files of
these names lie in ../shared/models. With no network, a torus of our own. Nothing else should run on the machine.
"""


def write_json(text, file):
    if file:
        put_file(text.encode(), file)


def make_table(meshes, file, quick):
    options = ["--precompute", *(["--seconds", "5"] if quick else [])]
    if not meshes:
        meshes = core_times.table_models("bunny", "igea", "dragon_res2", *([] if quick else ["dragon"]))
        options += [] if quick else ["--subdivide", "2"]
    program = core_times.build_benchmarks("extraction_table")
    core = core_times.measure(program, *options, *meshes)
    in_meshlab = "null" if quick else core_times.measure_in_meshlab(meshes[-1])
    write_json(f'{{"commit": "{core_times.commit()}",\n"core": {core},\n"in_meshlab": {in_meshlab}}}\n', file)


def main():
    words, meshes, file, quick, mode = sys.argv[1:], [], "", False, "table"
    while words:
        word = words.pop(0)
        if word in ("-h", "--help"):
            print(USAGE, end="")
            return
        if word == "--json":
            if not words:
                raise Failure("--json needs the name of a file")
            file = words.pop(0)
        elif word == "--quick":
            quick = True
        elif word in ("--paper", "--busy", "--instructions"):
            mode = word[2:]
        elif word == "--steps":
            return run([core_times.build_benchmarks("core_benchmarks", "libbenchmark-dev"), *words])
        elif word == "--truth":
            return drawing_truth.hold_against_parts(words)
        elif word == "--silhouettes":
            return drawing_truth.hold_against_silhouettes(words)
        elif word.startswith("-"):
            raise Failure(f"unknown option {word}; see ./bench --help")
        else:
            check_mesh(word)
            meshes.append(word)
    folder = os.path.dirname(file) or "."
    if file and (os.path.isdir(file) or not os.access(file if os.path.exists(file) else folder, os.W_OK)):
        raise Failure(f"cannot write {file}")
    if mode == "instructions":
        meshes = meshes or core_times.table_models("dragon_res2")
        if len(meshes) != 1:
            raise Failure("--instructions needs one MESH")
        core_times.count_instructions(core_times.build_benchmarks("extraction_instructions", "valgrind"), meshes[0])
    elif mode == "table":
        make_table(meshes, file, quick)
    else:
        meshes = meshes or core_times.table_models("bunny", "igea", "dragon")
        write_json(core_times.measure(core_times.build_benchmarks(f"{mode}_table"), *meshes), file)


run_main(main)
