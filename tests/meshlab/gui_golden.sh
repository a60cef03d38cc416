#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Small pictures that were looked at once and found right: a change of the drawing that no other test measures shows here.
# After a wanted change, look at the new ones in the build folder's Testing/meshlab/gui_golden and copy them to golden/.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

[[ $(meshlab_version) == 2020.* ]] || {
    say "skipped: the golden pictures are of MeshLab 2020.09"
    exit 77
}

golden=$(dirname "$(readlink -f "$0")")/golden

# expect_golden NAME: blurred by a pixel, since versions of OpenGL differ in the edges of strokes
expect_golden() {
    local difference
    [[ -f $golden/$1.png ]] || fail "there is no golden picture $1.png"
    difference=$(convert "$WORK/$1.png" "$golden/$1.png" -alpha off -blur 0x1 miff:- |
        compare -metric RMSE - null: 2>&1 | sed 's/.*(\(.*\))/\1/') || true
    say "$1 differs by $difference"
    awk "BEGIN { exit !(\"$difference\" ~ /^[0-9.e-]+\$/ && $difference < 0.015) }" ||
        fail "$1.png differs by $difference from the golden picture (0: the same, 1: black on white)"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<'END'
setdeco Line Color = #000000
setdeco Contour Color = #000000
size 320x240
setdeco Drawing Style = Publication (Black on White)
look 2.2 1.3 2.2  0 0 0
grab publication.png
setdeco Hidden Lines = Dashed
grab dashed.png
setdeco Hidden Lines = Left Out
setdeco Single Strokes = off
grab paper_form.png
setdeco Single Strokes = on
setdeco Drawing Style = Archaeology (Side Light)
grab archaeology.png
setdeco Drawing Style = Custom
setdeco Surface = Toon
setdeco Background = Paper Color
grab toon.png
END

for picture in publication dashed paper_form archaeology toon; do
    expect_golden "$picture"
done
