# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter in scripts of meshlabserver: every parameter, every choice, what it says and what it leaves alone.

Not tested, because MeshLab 2020.09 itself ends there by an assertion (exit code 134): a script in which a parameter
other than the first is missing or holds text that is not a number."""
from harness import *

EXAMPLE = "laplacian_lines.mlx"


def expect_said(*regexes):
    for regex in regexes:
        expect_text("log", regex)


small_torus()
accept("out.ply", EXAMPLE)
expect_said("Laplacian lines: 1200 vertices, 2400 triangles", r"= 2\.00 mean edges =",
            r"Roughness [01]\.[0-9]+: normals smoothed by 0\.80 mean edges",
            r"Laplace Operator: Heat Kernel \(Belkin\), Normal Weighting: Area, Normal Smoothing: Gaussian, Gradient Estimator: Triangle Fit",
            "stored per vertex in ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal, ll_kernel_size")
accept("all.ply", EXAMPLE, kernel_size=0.2, kernel_mode=1, laplace_operator=1, accuracy=0.01, normal_weighting=2,
       normal_smoothing=2,
       normal_sigma=1.5, bilateral_angle=40, gradient_estimator=1, gradient_radius=2, correct_borders="false",
       skip_opposite_sheet="false")
expect_said(r"Kernel size 0\.2 in mesh units", r"Normals smoothed by 1\.50 mean edges",
            "Kernel: Adaptive, Laplace Operator: Cotangent, Normal Weighting: Max, Normal Smoothing: Bilateral, "
            "Gradient Estimator: Least Squares")
accept("out.ply", EXAMPLE, normal_weighting=1, normal_smoothing=0)
expect_said("Normal Weighting: Angle, Normal Smoothing: None")
expect(same_file("out.ply", "all.ply"), "the mesh depends on the parameters")

for key, value, reason in (
        ("accuracy", "nan", r'"Accuracy" is not a number\. It has to be between 1e-06 and 0\.1'),
        ("kernel_size", -1, r'"Kernel Size" is -1\. It has to be at least 0'),
        ("laplace_operator", 2,
         r'"Laplace Operator" is 2\. It has to be one of 0 \(Heat Kernel \(Belkin\)\), 1 \(Cotangent\)')):
    refuse(reason, EXAMPLE, **{key: value})
