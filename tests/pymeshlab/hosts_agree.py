# SPDX-License-Identifier: GPL-3.0-or-later
"""The example script gives the same attributes in PyMeshLab and in every MeshLab whose tests have run before.

They are built by different compilers and of different precision. MeshLab's are in the files that its own tests have
saved; without any, or with none that is newer than the plugins' sources, the test is skipped.
"""

import sys

import laplacian_lines
import numpy
from harness import BUILD, EXAMPLES, expect_same_field, largest_difference, meshes

ROOT = EXAMPLES.parent
PLACES = ("Testing/meshlab/gui_script/torus.ply", "Testing/meshlab/server/out.ply")
SOURCES = ("laplacian_lines", "meshlab_host", "filter_laplacian_lines", "tests/meshes")
TYPES = {"float": "<f4", "double": "<f8", "int": "<i4", "uchar": "u1"}
ROUNDING = 1e-5  # of the largest value: some hundred roundings to float


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


def read_attributes(path):
    header, end, data = path.read_bytes().partition(b"end_header\n")
    assert end and b"format binary_little_endian" in header
    kind, count = vertex_type(header)
    vertices = numpy.frombuffer(data, kind, count)
    assert "ll_kernel_size" in kind.names, f"{path} has no attributes: its own test has failed"
    attributes = {"ll_kernel_size": vertices["ll_kernel_size"]}
    for name in ("ll_normal", "ll_laplacian_normal", "ll_shape_diagonal", "ll_shape_off_diagonal"):
        if name in kind.names:
            assert (vertices[name + "_size"] == 3).all()
            attributes[name] = vertices[name]
        else:  # MeshLab 2020.09 has three numbers
            attributes[name] = numpy.stack([vertices[f"{name}_{axis}"] for axis in "xyz"], axis=1)
    return attributes


def changed():
    """When the sources were changed last, in seconds."""
    return max(file.stat().st_mtime for folder in SOURCES for file in (ROOT / folder).rglob("*.*"))


builds = [ROOT / "build", *sorted((ROOT / "build").glob("host-*"))]
files = [build / place for build in builds for place in PLACES if build != BUILD and (build / place).exists()]
current = [file for file in files if file.stat().st_mtime > changed()]
for file in set(files) - set(current):
    print(f"older than the sources: {file}")
if not current:
    print("no other host's tests have run: ./test --host all")
    sys.exit(77)

ms = meshes()
ms.load_filter_script(str(EXAMPLES / "laplacian_lines.mlx"))
ms.apply_filter_script()
field = laplacian_lines.field(ms.current_mesh())
for file in current:
    attributes = read_attributes(file)
    expect_same_field(attributes, field, ROUNDING)
    worst = max(largest_difference(attributes[name], field[name]) for name in field)
    print(f"agrees to {worst:.2g}: {file}")
