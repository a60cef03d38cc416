#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Faces that MeshLab culls hide no lines, in any render mode. Of a surface turned inside out it culls the near ones.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# expect_about A B: A differs by at most a fifth from B
expect_about() {
    ((10 * $1 >= 8 * $2 && 10 * $1 <= 12 * $2)) || fail "$1 is not about $2"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
look 2.8 0.2 0.9  0 0 0
trigger Invert Faces Orientation
set Force Flip = on
apply
close
check Wireframe on
grab wires_on_fill.png
check Fill off
grab wires.png
# an option of faces
check Fill on
check Cull on
grab culled_wires_on_fill.png
check Fill off
grab culled_wires.png
END
hidden=$(red_pixels "$WORK/wires_on_fill.png") shown=$(red_pixels "$WORK/culled_wires_on_fill.png")
((shown > 2 * hidden && hidden > 1000)) || fail "$shown pixels of lines with culling, $hidden without"
expect_about "$(red_pixels "$WORK/wires.png")" "$hidden"
expect_about "$(red_pixels "$WORK/culled_wires.png")" "$shown"
