#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Layers hide each other's lines, also where MeshLab shows no faces, and those that are hidden or gone do not.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# layers NAME: both, one alone, both again. A layer that has been hidden or shown is noticed by the next redraw, which
# asks for another one.
layers() {
    cat <<END
grab $1.png
show-layer torus
sleep 200
grab $1_ring.png
show-layer torus
sleep 200
grab $1_again.png
END
}

# lines FILE: where the lines' red is
lines() {
    convert "$WORK/$1.png" -alpha off -fuzz 35% -fill black +opaque red -fill white -opaque red -colorspace gray \
        "$WORK/$1_lines.png"
}

# expect_no_more_lines A B: all of A's are B's, or within three pixels of them
expect_no_more_lines() {
    local more
    more=$(convert "$WORK/$1_lines.png" \( "$WORK/$2_lines.png" -morphology Dilate Square:3 -negate \) \
        -compose multiply -composite -format '%[fx:round(mean*w*h)]' info:)
    ((more <= 500)) || fail "$1 has $more pixels of lines where $2 has none"
}

torus "$WORK/torus.ply"
write_bumpy_torus 120 60 >"$WORK/ring.ply"
drive_lines torus.ply <<END
open ring.ply
select-layer ring
# like the next ring of a chain: each hides a part of the other
trigger Matrix: Set from translation/rotation/scale
set Freeze Matrix = off
set X Translation = 0.9
set X Rotation = 80
set Y Rotation = 20
apply
close
check Laplacian Lines on
slot view resetTrackBall
wheel -4
drag 0.4 0.4 0.5 0.5
$(layers fill)
# drawn after the torus, and without faces
select-layer ring
check Fill off
$(layers faceless)
END
for picture in '' _ring _again; do
    lines "fill$picture"
    lines "faceless$picture"
    expect_no_more_lines "fill$picture" "faceless$picture"
    expect_no_more_lines "faceless$picture" "fill$picture"
done
