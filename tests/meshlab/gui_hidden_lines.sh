#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines behind the surface are hidden in every render mode, or drawn faint or dashed if the user wants them.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# hidden NAME: the three ways
hidden() {
    cat <<END
expect-lines
grab $1_left_out.png
setdeco Hidden Lines = Dashed
expect-other-lines
grab $1_dashed.png
setdeco Hidden Lines = Faint
grab $1_faint.png
setdeco Hidden Lines = Left Out
expect-lines
END
}

# ink FILE, pale FILE: pixels of nearly pure red, and those that are anything between white and red. The edges of lines
# blend with what is below, which has other colours in other versions of MeshLab.
ink() {
    convert "$WORK/$1" -alpha off -fuzz 15% -fill black +opaque red -fill white -opaque red -colorspace gray \
        -format '%[fx:round(mean*w*h)]' info:
}

pale() {
    convert "$WORK/$1" -alpha off -fuzz 2% -fill black -opaque white -fill white +opaque black -colorspace gray \
        -format '%[fx:round(mean*w*h)]' info:
}

# expect_between LEAST VALUE MOST WHAT
expect_between() {
    (($1 <= $2 && $2 <= $3)) || fail "$4: $2 is not between $1 and $3"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
look 2.8 0.2 0.9  0 0 0
$(hidden fill)
setdeco Surface = Paper
$(hidden paper)
setdeco Surface = As MeshLab Draws It
check Wireframe on
$(hidden wireframe_on_fill)
check Fill off
$(hidden wireframe)
check Points on
check Wireframe off
$(hidden points)
trigger Toggle Orthographic Camera
$(hidden orthographic_points)
END
seen=$(ink fill_left_out.png)
for mode in fill paper wireframe_on_fill wireframe points; do
    # there are more lines behind than that
    expect_between $((seen * 80 / 100)) "$(ink ${mode}_left_out.png)" $((seen * 110 / 100)) "ink in mode $mode"
    expect_between $((seen * 95 / 100)) "$(ink ${mode}_dashed.png)" $((seen * 200 / 100)) "dashes in mode $mode"
done
expect_between $(($(ink paper_left_out.png) + 500)) "$(ink paper_dashed.png)" 100000 "ink with dashes"
expect_between $(($(pale paper_left_out.png) + 1000)) "$(pale paper_faint.png)" 100000 "pixels with faint lines"
expect_between 0 "$(ink paper_faint.png)" $(($(ink paper_left_out.png) + 400)) "strong ink with faint lines"
