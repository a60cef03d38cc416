#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --picture --kinds: a column for each kind of lines and a row for each mesh, another one with noise; edges of
# pictures beside them, where scikit-image can be had; a mesh that fails does not stop the others.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/picture product/settings
stop_display # it starts one of its own

# take CODE KINDS NOISE MESH...: expects this exit code; the drawings are in $WORK/drawings, what is said in $WORK/log
take() {
    local expected=$1 kinds=$2 noise=$3 code=0
    shift 3
    rm -rf "$WORK/drawings"
    mkdir "$WORK/drawings"
    (
        trap stop_display EXIT
        PICTURE_SIZE=300x200 PICTURE_KINDS=$kinds PICTURE_NOISE=$noise
        [[ -z $kinds ]] || read_columns "$LAPLACIAN_LINES_BUILD" "$kinds"
        take_pictures "$STAGE" "$WORK/drawings" "$WORK/sheet.png" "$@"
    ) 2>"$WORK/log" || code=$?
    ((code == expected)) || fail "it ended with $code instead of $expected: $(tail -n 1 "$WORK/log")"
}

# drawn ROW COLUMN
drawn() {
    printf '%s/drawings/drawing_%d_0_%d.png' "$WORK" "$1" "$2"
}

torus "$WORK/torus.ply"
printf 'not a mesh\n' >"$WORK/broken.ply"

take 0 usual "" "$WORK/torus.ply"
cp "$WORK/sheet.png" "$WORK/plain.png"
take 0 "" "" "$WORK/torus.ply"
(($(differing_pixels "$WORK/plain.png" "$WORK/sheet.png") > 50)) || fail "the kernel does not go with the picture's size"

kinds=usual,apparent_ridges,laplacian_lines,ridges+valleys,suggestive_contours_and_highlights,contours
take 1 "$kinds" 0.2 "$WORK/torus.ply" "$WORK/broken.ply"
expect_text "$WORK/log" "broken.ply: MeshLab cannot read it"
read -r width height < <(identify -format '%w %h\n' "$WORK/sheet.png")
((width == 6 * 316 && height > 2 * 216 && height < 3 * 216)) || fail "the sheet is ${width}x$height"
expect_same_picture "$WORK/plain.png" "$(drawn 0 0)" 0
for a in 0 1 2 3 4 5; do
    (($(differing_pixels "$(drawn 0 $a)" "$(drawn 1 $a)") > 100)) || fail "noise does not change column $a"
    for ((b = a + 1; b < 6; ++b)); do
        (($(differing_pixels "$(drawn 0 $a)" "$(drawn 0 $b)") > 50)) || fail "the columns $a and $b are the same"
    done
done
# highlights are white on gray, and what follows is on white again
[[ $(convert "$(drawn 0 4)" -format '%[hex:u.p{9,9}]' info:) == A8A8A8* ]] || fail "the paper under highlights is not gray"
lights=$(convert "$(drawn 0 4)" -shave 12x12 -threshold 80% -format '%[fx:round(mean*w*h)]' info:)
((lights > 20 && lights < 2000)) || fail "$lights pixels of highlights"
[[ $(convert "$(drawn 0 5)" -format '%[hex:u.p{9,9}]' info:) == FFFFFF* ]] || fail "the paper after highlights is not white"

# the same noise again
cp "$(drawn 1 0)" "$WORK/noisy.png"
take 0 usual 0.2 "$WORK/torus.ply"
expect_same_picture "$WORK/noisy.png" "$(drawn 1 0)" 0

! (read_columns "$LAPLACIAN_LINES_BUILD" ridge) 2>"$WORK/log" || fail "there are no lines called ridge"
expect_text "$WORK/log" '^laplacian-lines: --kinds: there are no lines "ridge". Name some of usual, '

if (ensure_image_tools) 2>"$WORK/log"; then
    take 0 log,canny,contours "" "$WORK/torus.ply"
    for column in 0 1; do
        ink=$(convert "$(drawn 0 $column)" -colorspace gray -negate -format '%[fx:mean]' info:)
        awk -v ink="$ink" 'BEGIN { exit !(ink > 0.005 && ink < 0.2) }' || fail "the edges of column $column cover $ink"
    done
    (($(differing_pixels "$(drawn 0 0)" "$(drawn 0 1)") > 50)) || fail "both detectors give the same edges"
else
    printf 'without edges of pictures: %s\n' "$(tail -n 1 "$WORK/log")"
fi
