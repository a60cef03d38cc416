#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The filter with parameters chosen in its dialog: what it says, and that the lines shown are those of its attributes.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

CHOSEN='kernel_size=0.12 kernel_mode=1 accuracy=0.0005 normal_weighting=2 normal_smoothing=2 normal_sigma=1.25'
CHOSEN+=' bilateral_angle=35 gradient_estimator=1 gradient_radius=4 correct_borders=0 skip_opposite_sheet=0'

torus "$WORK/torus.ply"
drive <<END
wait
open torus.ply
size 800x600
trigger Compute Laplacian Lines
set Kernel Size (abs and %) = 0.12
set Kernel = Adaptive
set Laplace Operator = Heat Kernel (Belkin)
set Accuracy = 0.0005
set Normal Weighting = Max
set Normal Smoothing = Bilateral
set Normal Smoothing Sigma = 1.25
set Bilateral Angle = 35
set Gradient Estimator = Least Squares
set Gradient Radius = 4
set Correct Borders = off
set Skip Opposite Sheet = off
apply
close
expect-log Laplacian lines: 12800 vertices, 25600 triangles\n
expect-log Kernel size 0\.12 in mesh units = 2\.8\d mean edges = 2\.9\d % of the bounding-box diagonal\n
expect-log Kernel: Adaptive, Laplace Operator: Heat Kernel \(Belkin\), Normal Weighting: Max, Normal Smoothing: Bilateral, Gradient Estimator: Least Squares\n
expect-log Computed in \d+\.\d\d s, stored per vertex in ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal, ll_kernel_size\n
expect-no-log Left out
$(show_lines)
expect-lines $CHOSEN
expect-other-lines
expect-no-log computed with the default options

# a wrong value changes nothing
trigger Compute Laplacian Lines
set Accuracy = 5
apply
expect-modal Filter Failure: .*"Accuracy" is 5\. It has to be between 1e-06 and 0\.1
button OK
close
expect-lines $CHOSEN
expect-no-log computed with the default options
expect-log (Filter|Compute Laplacian Lines) failed: "Accuracy" is 5

# a percentage of the diagonal, and the defaults
trigger Compute Laplacian Lines
set Kernel Size (abs and %) = 2%
apply
expect-log = 2.00 % of the bounding-box diagonal
expect-lines kernel_size=0.0823
defaults
apply
close
expect-lines
expect-no-log computed with the default options

search laplacian lines = Compute Laplacian Lines
set Laplace Operator = Cotangent
apply
close
expect-log Laplace Operator: Cotangent
expect-lines laplace_operator=1
expect-other-lines
search laplacian lines = Laplacian Lines
expect-no-lines
END
