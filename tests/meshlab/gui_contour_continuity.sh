#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The contour of a sphere is a ring without gaps, from near and far, in every render mode.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# twenty zooms, from a view that is filled to one a tenth as wide
mapfile -t distances < <(awk 'BEGIN { for (i = 0; i < 20; i++) printf "%.3f\n", 2.2 * 10 ^ (i / 19) }')

# rings NAME: pictures from all distances
rings() {
    local distance
    for distance in "${distances[@]}"; do
        awk "BEGIN { d = $distance; print \"look\", 0.6 * d, 0.64 * d, 0.48 * d, \" 0 0 0\" }"
        echo "grab $1_$distance.png"
    done
}

# expect_ring FILE: on every ray from the middle of the picture lies ink, or a pixel beside it
expect_ring() {
    local least
    least=$(convert "$WORK/$1" -alpha off -fuzz 45% -fill black +opaque red -fill white -opaque red -colorspace gray \
        -morphology Dilate Square:1 -distort DePolar 0 -scale 'x1!' -format '%[fx:minima > 0]' info:)
    ((least == 1)) || fail "the ring in $1 has a gap"
}

sphere "$WORK/sphere.ply"
drive_lines sphere.ply <<END
size 600x600
setdeco Laplacian Lines = off
setdeco Ridges = off
$(rings fill)
check Wireframe on
check Fill off
$(rings wireframe)
check Points on
check Wireframe off
$(rings points)
END
for mode in fill wireframe points; do
    for distance in "${distances[@]}"; do
        expect_ring "${mode}_$distance.png"
    done
done
