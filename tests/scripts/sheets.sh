#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sheets of many pictures are no wider than a screen and no higher than ImageMagick allows, and what belongs together
# stands in rows of its own.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages product/sheet

# expect COLUMNS CELL SIZE COUNT TOGETHER
expect() {
    lay_out_sheet "${@:3}"
    [[ $SHEET_COLUMNS == "$1" && $SHEET_CELL == "$2" ]] || fail "${*:3}: $SHEET_COLUMNS columns of $SHEET_CELL"
}

expect 3 1200x900 1200x900 18 18 # all kinds of lines of a mesh
expect 3 1200x900 1200x900 36 18 # of two
expect 2 1200x900 1200x900 8 4   # rows of four would be too wide, rows of three and one uneven
expect 2 1200x900 1200x900 2 2
expect 3 500x400 500x400 7 7
expect 6 300x200 300x200 12 6
expect 1 5000x400 5000x400 3 3
expect 6 614x460 1200x900 100 1 # a hundred meshes

for size in 1200x900 300x4000 9000x100; do
    for count in 1 7 40 400; do
        for together in 1 3 18; do
            lay_out_sheet "$size" "$count" "$together"
            width=$((SHEET_COLUMNS * (${SHEET_CELL%x*} + 16)))
            height=$(($(sheet_rows "$SHEET_COLUMNS" "$count" "$together") * (${SHEET_CELL#*x} + 76)))
            ((width <= 3840 || SHEET_COLUMNS == 1)) || fail "$count of $size, $together together: $width wide"
            ((height <= 16000 || ${SHEET_CELL%x*} <= 100)) || fail "$count of $size, $together together: $height high"
        done
    done
done

# five pictures and five others, in rows of three: the sixth cell is empty
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
convert -size 1000x50 xc:black "$work/black.png"
convert -size 1000x50 xc:red "$work/red.png"
cells=()
for number in 1 2 3 4 5; do cells+=("$number" "$work/black.png"); done
for number in 1 2 3 4 5; do cells+=("$number" "$work/red.png"); done
make_sheet "$work/sheet.png" 1000x50 5 "${cells[@]}"
row=$(($(identify -format %h "$work/sheet.png") / 4))
[[ $(identify -format %w "$work/sheet.png") == 3048 && $((4 * row)) == $(identify -format %h "$work/sheet.png") ]] ||
    fail "the sheet is $(identify -format %wx%h "$work/sheet.png")"
colors=$(for place in 0,0 1,1 2,1 0,2 1,3 2,3; do
    x=$((1016 * ${place%,*} + 500)) y=$((row * ${place#*,} + 20))
    convert "$work/sheet.png" -format "%[hex:u.p{$x,$y}] " info:
done)
[[ $colors == "000000 000000 FFFFFF FF0000 FF0000 FFFFFF " ]] || fail "the cells are $colors"
