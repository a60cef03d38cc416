# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter in scripts of meshlabserver, or of what ./run --server runs in its place: parameters, choices, what it says,
what it leaves alone and what it refuses.

Not tested, because MeshLab 2020.09 itself ends there by an assertion (exit code 134): a script in which a parameter
other than the first is missing or holds text that is not a number."""
from harness import *

EXAMPLE = "laplacian_lines.mlx"


def expect_said(*regexes):
    for regex in regexes:
        expect_text("log", regex)


small_torus()
accept("out.ply", EXAMPLE)
expect_said("Laplacian lines: 1200 vertices, 2400 triangles", r"= 1\.00 mean edges =",
            r"Roughness 0\.[0-9]+, normals smoothed by 0\.[0-9]+ mean edges", "Normal Smoothing: Gaussian",
            "stored per vertex in ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal")
accept("all.ply", EXAMPLE, kernel_size=0.2, laplace_operator=1, normal_sigma=1.5, gradient_estimator=1)
expect_said(r"Kernel size 0\.2 in mesh units", r"Normals smoothed by 1\.50 mean edges", "Laplace Operator: Cotangent",
            "Normal Smoothing: Gaussian", "Gradient Estimator: Least Squares")
expect(same_file("out.ply", "all.ply"), "the mesh depends on the parameters")

for key, value, reason in (
        ("kernel_size", -1, r'"Kernel Size" is -1\. It has to be at least 0'),
        ("normal_sigma", -1, r'"Normal Smoothing Sigma" is -1\. It has to be '),
        ("laplace_operator", 2,
         r'"Laplace Operator" is 2\. It has to be one of 0 \(Heat Kernel \(Belkin\)\), 1 \(Cotangent\)|Enum 2 not valid')):
    refuse(reason, EXAMPLE, **{key: value})

# faults of meshes are counted; from 2022.02 on, MeshLab itself takes out some of them when it opens a mesh
lines = text_of("torus.ply").split("end_header\n")[1].splitlines()
ply("dirty.ply", [*lines[:1200], "nan 0 0", "3 3 3", "inf 0 0", "5 5 5"],
    [*lines[1200:], "3 0 1 1200", "3 0 1201 1", "3 7 7 8"])
accept("out.ply", EXAMPLE, mesh="dirty.ply")
expect_said(("" if "MESH_SERVER" in os.environ else "2 vertices with non-finite coordinates, 2 triangles without a finite area, ")
            + "1 vertex without triangles$")
for vertices, faces in ((["0 0 0", "1 0 0", "2 0 0"], ["3 0 1 2"]), (["0 0 0", "1 0 0", "0 1 0"], [])):
    ply("flat.ply", vertices, faces)
    refuse("The mesh has no triangle with an area|(lacks:|does not have) Any Faces", EXAMPLE, mesh="flat.ply")
