#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab loads both plugins and offers their actions.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

small_torus "$WORK/torus.ply"
drive <<'END'
wait
open torus.ply
expect-action Compute Laplacian Lines
expect-action Laplacian Lines unchecked
check Laplacian Lines on
size 640x480
grab lines.png
expect-action Laplacian Lines checked
END
expect_picture "$WORK/lines.png" 640x480
