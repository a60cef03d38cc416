#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --picture: a drawing on white paper, also with parameters of the decoration, and a sheet of two views of an unpacked
# mesh.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/picture product/settings
stop_display # it starts one of its own

# dark_pixels FILE
dark_pixels() {
    convert "$1" -alpha off -colorspace gray -threshold 50% -negate -format '%[fx:round(mean*w*h)]' info:
}

# take FILE: of $views and $meshes
take() {
    check_picture "$1"
    take_pictures "$STAGE" "$WORK" "$1" 500x400 views meshes
    stop_display
}

torus "$WORK/torus.ply"
meshes=("$WORK/torus.ply") views=("")
take "$WORK/drawing.png"
expect_picture "$WORK/drawing.png" 500x400
ink=$(dark_pixels "$WORK/drawing.png")
((ink > 1000 && ink < 40000)) || fail "$ink dark pixels are no drawing"
[[ $(convert "$WORK/drawing.png" -format '%[pixel:p{2,2}]' info:) =~ white|255,255,255 ]] || fail "the paper is not white"

# take_with SETTING...: with_settings.png
take_with() {
    write_settings "$LAPLACIAN_LINES_BUILD" "$WORK/settings" "$@"
    take "$WORK/with_settings.png"
    rm "$WORK/settings"
}
take_with "Drawing Style=Publication"
expect_same_picture "$WORK/drawing.png" "$WORK/with_settings.png" 0
take_with "Line Color=red" "Contour Color=red" "Line Width=4"
(($(red_pixels "$WORK/with_settings.png") > 3 * ink / 2)) || fail "the lines are not red and wide"

gzip "$WORK/torus.ply"
meshes=("$WORK/torus.ply.gz") views=("30,15" "-60,0")
take "$WORK/sheet.png"
read -r width height < <(identify -format '%w %h\n' "$WORK/sheet.png")
((width == 2 * 516 && height > 416)) || fail "the sheet is ${width}x$height"
((2 * ink < 3 * $(dark_pixels "$WORK/sheet.png"))) || fail "the sheet holds less than two drawings"
