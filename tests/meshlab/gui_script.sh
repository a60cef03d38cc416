#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The example script in MeshLab's own script dialog gives the core's results.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

reference_mesh torus
drive <<END
wait
open torus.ply
trigger Show current filter script
expect-modal .*
button Open Script
set-modal File name: = $EXAMPLE
button Apply Script
trigger Export Mesh...
set-modal Binary encoding = on
set-modal V(f): ll_kernel_size = on
set-modal V(3f): ll_normal = on
set-modal V(3f): ll_laplacian_normal = on
set-modal V(3f): ll_shape_diagonal = on
set-modal V(3f): ll_shape_off_diagonal = on
button OK
END
expect_reference_attributes "$WORK/torus.ply"
