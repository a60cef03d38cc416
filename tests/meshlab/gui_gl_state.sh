#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Drawing lines leaves no trace in OpenGL's state nor in what MeshLab and other decorations draw, in any render mode.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# pictures NAME: without lines; with our decoration on but nothing to draw; with lines; without again. Decorations are
# drawn in the order in which they were switched on: MeshLab's own come after ours here.
pictures() {
    cat <<END
grab $1_plain.png
$(others on)
grab $1_others.png
gl-state $1_others.txt
$(others off)

check Laplacian Lines on
grab $1_lines.png
$(others on)
gl-state $1_lines_others.txt
setdeco Occluding Contours = off
setdeco Laplacian Lines = off
setdeco Ridges = off
grab $1_nothing_others.png
$(others off)
grab $1_nothing.png
setdeco Occluding Contours = on
setdeco Laplacian Lines = on
setdeco Ridges = on
check Laplacian Lines off
grab $1_after.png
END
}

others() {
    printf 'check %s '"$1"'\n' 'Show Box Corners' 'Show Normal' 'Laplacian Lines Probe'
}

torus "$WORK/torus.ply"
drive <<END
wait
open torus.ply
size 800x600
check Show Info Panel off
check Show Trackball off
look 1.8 0.5 1.8  0 0 0
$(pictures fill)
check Wireframe on
$(pictures wireframe_on_fill)
check Fill off
$(pictures wireframe)
check Points on
check Wireframe off
$(pictures points)
check Fill on
check Points off
trigger toon.gdp
$(pictures shader)
END
for mode in fill wireframe_on_fill wireframe points shader; do
    expect_same_picture "$WORK/${mode}_plain.png" "$WORK/${mode}_nothing.png" 0
    expect_same_picture "$WORK/${mode}_others.png" "$WORK/${mode}_nothing_others.png" 0
    expect_same_picture "$WORK/${mode}_plain.png" "$WORK/${mode}_after.png" 0
    ! cmp -s "$WORK/${mode}_plain.png" "$WORK/${mode}_lines.png" || fail "no lines are drawn in mode $mode"
    diff "$WORK/${mode}_others.txt" "$WORK/${mode}_lines_others.txt" || fail "the lines change OpenGL's state in mode $mode"
done
