#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The filter in scripts of meshlabserver: every parameter, every choice, what it says and what it leaves alone.
#
# Not tested, because MeshLab 2020.09 itself ends there by an assertion (exit code 134): a script in which a parameter
# other than the first is missing or holds text that is not a number.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# accept [KEY=VALUE...]: a script that works
accept() {
    write_script script.mlx "$@"
    rm -f "$WORK/out.ply"
    serve -i torus.ply -s script.mlx -o out.ply
    ((SERVER_CODE == 0)) || fail "the script with $* ended with $SERVER_CODE"
    [[ -s $WORK/out.ply ]] || fail "the script with $* wrote no mesh"
}

small_torus "$WORK/torus.ply"
accept
expect_text "$WORK/log" 'Laplacian lines: 1200 vertices, 2400 triangles'
expect_text "$WORK/log" '= 2\.00 mean edges ='
expect_text "$WORK/log" 'Roughness [01]\.[0-9]+: normals smoothed by 0\.80 mean edges'
expect_text "$WORK/log" 'Laplace Operator: Heat Kernel \(Belkin\), Normal Weighting: Area, Normal Smoothing: Gaussian, Gradient Estimator: Triangle Fit'
expect_text "$WORK/log" 'stored per vertex in ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal, ll_kernel_size'

accept kernel_size=0.2 kernel_mode=1 laplace_operator=1 accuracy=0.01 normal_weighting=2 normal_smoothing=2 \
    normal_sigma=1.5 bilateral_angle=40 gradient_estimator=1 gradient_radius=2 correct_borders=false skip_opposite_sheet=false
expect_text "$WORK/log" 'Kernel size 0\.2 in mesh units'
expect_text "$WORK/log" 'Normals smoothed by 1\.50 mean edges'
expect_text "$WORK/log" 'Kernel: Adaptive, Laplace Operator: Cotangent, Normal Weighting: Max, Normal Smoothing: Bilateral, Gradient Estimator: Least Squares'
cp "$WORK/out.ply" "$WORK/all.ply"
accept normal_weighting=1 normal_smoothing=0
expect_text "$WORK/log" 'Normal Weighting: Angle, Normal Smoothing: None'
cmp -s "$WORK/out.ply" "$WORK/all.ply" || fail "the mesh depends on the parameters"

refuse_settings '"Accuracy" is 5\. It has to be between 1e-06 and 0\.1' accuracy=5
refuse_settings '"Accuracy" is not a number\. It has to be between 1e-06 and 0\.1' accuracy=nan
refuse_settings '"Kernel Size" is -1\. It has to be at least 0' kernel_size=-1
refuse_settings '"Kernel Size" is inf' kernel_size=inf
refuse_settings '"Laplace Operator" is 2\. It has to be one of 0 \(Heat Kernel \(Belkin\)\), 1 \(Cotangent\)' laplace_operator=2
refuse_settings '"Normal Smoothing" is -1\. It has to be one of 0 \(None\), 1 \(Gaussian\), 2 \(Bilateral\)' normal_smoothing=-1
refuse_settings '"Normal Smoothing Sigma" is 101\. It has to be between 0 and 100' normal_sigma=101
refuse_settings '"Bilateral Angle" is 0\. It has to be between 0\.1 and 180' bilateral_angle=0
refuse_settings '"Gradient Radius" is 0\.5\. It has to be between 1 and 100' gradient_radius=0.5
