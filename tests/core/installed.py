# SPDX-License-Identifier: GPL-3.0-or-later
"""installed.py EIGEN_INCLUDE_FOLDER: the core as "cmake --install" installs it. Each public header compiles alone and
names only Eigen, the standard library and others; the example is built against the package and finds a torus's lines."""
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

CHECKOUT, BUILD = pathlib.Path(__file__).resolve().parents[2], pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
CXX, EIGEN = os.environ["CXX"], sys.argv[1]
work = BUILD / "Testing/installed"
prefix = work / "prefix"


def run(*command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    assert done.returncode == 0, f"{command} says: {done.stdout}"


def compile_alone(header):
    """As a program sees it that includes nothing before."""
    run(CXX, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I", prefix / "include", "-isystem", EIGEN,
        "-x", "c++", "-", input=f"#include <laplacian_lines/{header.name}>\n")


def check_files():
    """Only the core's files are installed, and public headers include nothing but Eigen, the standard library and each other."""
    for file in filter(pathlib.Path.is_file, prefix.rglob("*")):
        assert re.search(r"/include/laplacian_lines/[a-z_]+\.h$|/cmake/LaplacianLines/LaplacianLines[A-Za-z-]+\.cmake$|/liblaplacian_lines\.a$",
                         str(file)), f"{file} is not a part of the core"
    headers = sorted((prefix / "include/laplacian_lines").iterdir())
    assert len(headers) > 10, f"only {len(headers)} public headers"
    for header in headers:
        for include in re.findall("^ *#include.*", header.read_text(), re.M):
            assert re.fullmatch(r'#include (<[a-z_]+>|<Eigen/[A-Za-z]+>|"laplacian_lines/[a-z_]+\.h")',
                                include), f"{header} has {include}"
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        list(pool.map(compile_alone, headers))


def write_torus(file):
    run(os.environ["WRITE_REFERENCE"], "torus", work)
    rows = [line.split() for line in (work / "torus.ply").read_text().split("end_header\n")[1].splitlines()]
    file.write_text("".join(
        f"v {' '.join(row)}\n" if len(row) == 3 else f"f {' '.join(str(int(word) + 1) for word in row[1:])}\n"
        for row in rows))


def check_lines(file):
    """Along its axis, a torus of the radii 1 and 0.4 has two outlines, circles of the radii 1.4 and 0.6."""
    lines = [line.split() for line in file.read_text().splitlines()]
    radii = [math.hypot(float(line[1]), float(line[2])) for line in lines if line[0] == "v"]
    used = [[int(word) for word in line[1:]] for line in lines if line[0] == "l"]
    outer, inner = (sum(abs(radius - wanted) < 0.02 for radius in radii) for wanted in (1.4, 0.6))
    print(f"{len(radii)} vertices in {len(used)} lines, {outer} and {inner} on the outlines")
    assert len(used) >= 2 and sum(map(len, used)) == len(radii) and outer > 40 and inner > 40, "these are not the lines of a torus"
    assert all(1 <= number <= len(radii) for line in used for number in line), "a line is of no vertex"


def check_example():
    run("cmake", "-S", CHECKOUT / "docs/examples/lines", "-B", work / "example", f"-DCMAKE_CXX_COMPILER={CXX}",
        f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", work / "example")
    example = work / "example/lines"
    write_torus(work / "torus.obj")
    run(example, work / "torus.obj", work / "lines.obj")
    check_lines(work / "lines.obj")
    done = subprocess.run([example, work / "none.obj", work / "none_lines.obj"], stderr=subprocess.PIPE, text=True)
    assert done.returncode != 0, "a file that is not there has lines"
    assert done.stderr.startswith("lines: The mesh has no triangle"), "the example does not say what is wrong"


shutil.rmtree(work, ignore_errors=True)
run("cmake", "--install", BUILD, "--component", "core", "--prefix", prefix)
check_files()
check_example()
