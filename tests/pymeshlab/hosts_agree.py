# SPDX-License-Identifier: GPL-3.0-or-later
"""The example scripts give the same attributes and lines in PyMeshLab and in every MeshLab whose tests have run before.

They are built by different compilers and of different precision. MeshLab's are in the files that its own tests have
saved; without any, or with none that is newer than the plugins' sources, the test is skipped.
"""

import sys

import laplacian_lines
import numpy
from harness import BUILD, EXAMPLES, MESH, expect_same_field, largest_difference, meshes

ROOT = EXAMPLES.parent
ATTRIBUTE_PLACES = ("Testing/meshlab/gui_script/torus.ply", "Testing/meshlab/server/out.ply")
LINE_PLACES = ("Testing/meshlab/scripts_polylines/lines.obj",)  # of torus.ply beside it
SOURCES = ("laplacian_lines", "meshlab_host", "filter_laplacian_lines", "tests/meshes")
TYPES = {"float": "<f4", "double": "<f8", "int": "<i4", "uchar": "u1"}
ROUNDING = 1e-5  # of the largest value: some hundred roundings to float
LINE_ROUNDING = 2e-6  # a length: the files have six digits after the point
SIGHT_ROUNDING = 1e-3  # a length: where a line comes into sight is found by halving


def vertex_type(header):
    """NumPy's type of a vertex, and how many there are. Lists are MeshLab's vectors: always of three."""
    fields, count, element = [], 0, ""
    for words in map(str.split, header.decode().splitlines()):
        if words[0] == "element":
            element = words[1]
            count = int(words[2]) if element == "vertex" else count
        elif words[0] == "property" and element == "vertex":
            if words[1] == "list":
                fields += [(words[-1] + "_size", TYPES[words[2]]), (words[-1], TYPES[words[3]], 3)]
            else:
                fields.append((words[-1], TYPES[words[1]]))
    return numpy.dtype(fields), count


def read_attributes(path, field):
    """Those that are in the field, as arrays of the same shapes."""
    header, end, data = path.read_bytes().partition(b"end_header\n")
    assert end and b"format binary_little_endian" in header
    kind, count = vertex_type(header)
    vertices = numpy.frombuffer(data, kind, count)
    assert "ll_kernel_size" in kind.names, f"{path} has no attributes: its own test has failed"
    attributes = {}
    for name, values in field.items():
        if name in kind.names:
            assert values.ndim == 1 or (vertices[name + "_size"] == 3).all()
            attributes[name] = vertices[name]
        else:  # MeshLab 2020.09 has three numbers
            attributes[name] = numpy.stack([vertices[f"{name}_{axis}"] for axis in "xyz"], axis=1)
    return attributes


def changed():
    """When the sources were changed last, in seconds."""
    return max(file.stat().st_mtime for folder in SOURCES for file in (ROOT / folder).rglob("*.*"))


def current_files(places):
    """What the other hosts have saved in these places since the sources were changed."""
    builds = [ROOT / "build", *sorted((ROOT / "build").glob("host-*"))]
    files = [build / place for build in builds for place in places if build != BUILD and (build / place).exists()]
    current = [file for file in files if file.stat().st_mtime > changed()]
    for file in set(files) - set(current):
        print(f"older than the sources: {file}")
    return current


def after_script(mesh, script):
    ms = meshes(mesh)
    ms.load_filter_script(str(EXAMPLES / script))
    ms.apply_filter_script()
    return ms.current_mesh()


def compare_attributes(files):
    field = laplacian_lines.field(after_script(MESH, "laplacian_lines.mlx"))
    for file in files:
        attributes = read_attributes(file, field)
        expect_same_field(attributes, field, ROUNDING)
        worst = max(largest_difference(attributes[name], field[name]) for name in field)
        print(f"agrees to {worst:.2g}: {file}")


def read_lines(path):
    """Vertices and edges, from 0, of an OBJ file."""
    rows = [line.split() for line in path.read_text().splitlines()]
    points = numpy.array([row[1:4] for row in rows if row and row[0] == "v"], dtype=float)
    edges = numpy.array([row[1:3] for row in rows if row and row[0] == "l"], dtype=int) - 1
    return points, edges


def compare_lines(files):
    for file in files:
        lines = after_script(file.with_name("torus.ply"), "laplacian_lines_polylines.mlx")
        points, edges = read_lines(file)
        assert len(edges) > 100 and numpy.array_equal(edges, lines.edge_matrix()), f"{file} has other edges"
        off = numpy.abs(points - lines.vertex_matrix()).max(axis=1)
        assert off.max() <= SIGHT_ROUNDING, f"the lines of {file} are off by {off.max():.3g}"
        ends = numpy.count_nonzero(off > LINE_ROUNDING)
        assert ends <= 0.01 * len(off), f"{ends} points of {file} are off by more than {LINE_ROUNDING}"
        print(f"the same lines to {numpy.median(off):.2g}, but for {ends} of {len(off)} points: {file}")


attribute_files, line_files = current_files(ATTRIBUTE_PLACES), current_files(LINE_PLACES)
if not attribute_files and not line_files:
    print("no other host's tests have run: ./test --host all")
    sys.exit(77)
compare_attributes(attribute_files)
compare_lines(line_files)
