#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the view shows are the lines of its camera: turned with the mouse, zoomed, orthographic.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
drive_lines torus.ply <<'END'
expect-lines
# the comparison does notice when they are not
expect-other-lines contours=0
expect-other-lines laplacian_lines=0
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
