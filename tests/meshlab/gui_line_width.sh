#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines are as wide as asked, in any render mode, and a symmetric mesh has a symmetric picture.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

widths=(1 2 3.5 6 9)

# widths NAME: the sphere's outline in all widths, on white
widths() {
    local width
    for width in "${widths[@]}"; do
        echo "setdeco Line Width = $width"
        echo "grab $1_$width.png"
    done
}

# expect_width FILE WIDTH: ink divided by the length of the ring, within half a pixel
expect_width() {
    local ink box measured
    ink=$(convert "$WORK/$1" -alpha off -format '%[fx:(mean.r-mean.g)*w*h]' info:)
    box=$(convert "$WORK/$1" -alpha off -fuzz 40% -fill white +opaque red -format '%@' info:)
    measured=$(awk -v ink="$ink" -v box="${box%%x*}" -v width="$2" \
        'BEGIN { print ink / ((box - width) * atan2(0, -1)) }')
    awk -v a="$measured" -v b="$2" 'BEGIN { exit !(a - b < 0.5 && b - a < 0.5) }' ||
        fail "the line in $1 is $measured pixels wide instead of $2"
    say "$1: $measured"
}

# expect_symmetric FILE: the mirrored picture, moved by no more than a pixel's edge
expect_symmetric() {
    convert "$WORK/$1" -alpha off -flop "$WORK/mirrored_$1"
    local differing
    differing=$(convert "$WORK/$1" "$WORK/mirrored_$1" -alpha off -compose Difference -composite \
        -colorspace gray -threshold 35% -format '%[fx:round(mean*w*h)]' info:)
    ((differing <= 150)) || fail "$differing pixels of $1 differ from its mirror image"
}

sphere "$WORK/sphere.ply"
drive_lines sphere.ply <<END
size 600x600
look 0 0 3  0 0 0  0 1 0
setdeco Contour Width Factor = 1
setdeco Laplacian Lines = off
setdeco Surface = Paper
$(widths fill)
check Wireframe on
check Fill off
$(widths wireframe)
END
for width in "${widths[@]}"; do
    expect_width "fill_$width.png" "$width"
    expect_width "wireframe_$width.png" "$width"
    expect_symmetric "fill_$width.png"
done
