#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the view shows are the lines of its camera: turned with the mouse, zoomed, orthographic.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

small_torus "$WORK/torus.ply"
drive <<'END'
wait
open torus.ply
size 800x600
check Show Info Panel off
check Show Trackball off
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Line Color = #ff0000
expect-lines
grab front.png
drag 0.5 0.5 0.7 0.62
expect-lines
drag 0.4 0.3 0.2 0.6
expect-lines
wheel 4
expect-lines
wheel -8
expect-lines
drag 0.5 0.5 0.6 0.4 left ctrl
expect-lines
trigger Toggle Orthographic Camera
expect-lines
drag 0.3 0.5 0.6 0.4
expect-lines
grab orthographic.png
check Laplacian Lines off
expect-no-lines
END
# and the comparison does notice when they are not
drive_to_failure "the view does not show the core's lines" <<'END'
wait
open torus.ply
size 800x600
check Show Info Panel off
check Show Trackball off
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Line Color = #ff0000
expect-lines contours=0
END
