#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Several views of one document: each shows the lines of its own camera, and each can have them on or off.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
size 1200x860
trigger Horizontally
expect-views 2
# a new view has no decorations yet
view 0
look 1.8 0.5 1.8  0 0 0
expect-lines
view 1
check Show Info Panel off
check Show Trackball off
expect-no-lines
$(show_lines)
expect-lines
look -2 1 -1.5  0 0 0
expect-lines
view 0
expect-lines
# no line is computed twice for the second view
expect-no-log computed with(.*\n)*.*computed with
setdeco Least Facing = 0.3
expect-lines least_facing=0.3
view 1
expect-lines least_facing=0.3
setdeco Least Facing = -0.15
view 0
check Laplacian Lines off
expect-no-lines
view 1
expect-lines
view 0
check Laplacian Lines on
expect-lines

view 1
trigger Vertically
expect-views 3
# the new view is on the left
view 1
expect-action Laplacian Lines unchecked
$(show_lines)
look 0.5 3 0.5  0 0 0
expect-lines
view 2
expect-lines
view 1
trigger Close current view
expect-views 2
view 0
expect-lines
trigger Close current view
expect-views 1
expect-lines
trigger Laplacian Smooth
apply
close
expect-lines
trigger Horizontally
expect-views 2
view 1
$(show_lines)
expect-lines
END
