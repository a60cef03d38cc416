#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --picture: a drawing on white paper, also with parameters of the decoration; sheets of views and meshes; from all
# sides, with any axis up, enlarged, without perspective; with lines that go with the size.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/picture product/settings
stop_display # it starts one of its own

# take FILE MESH OPTIONS...
take() {
    local file=$1 mesh=$2
    shift 2
    PICTURE_SIZE=500x400 PICTURE_UP=y PICTURE_ZOOM=1 PICTURE_PROJECTION=perspective PICTURE_VIEWS=()
    while (($#)); do
        picture_option "$@"
        shift "$OPTION_WORDS"
    done
    check_picture "$file"
    rm -rf "$WORK/drawings"
    mkdir "$WORK/drawings"
    [[ ! -e $WORK/settings ]] || cp "$WORK/settings" "$WORK/drawings"
    take_pictures "$STAGE" "$WORK/drawings" "$file" "$mesh"
    stop_display
}

# dark_pixels FILE
dark_pixels() {
    convert "$1" -alpha off -colorspace gray -threshold 50% -negate -format '%[fx:round(mean*w*h)]' info:
}

# drawn FILE: "WIDTH HEIGHT LEFT TOP" of what is not white
drawn() {
    convert "$1" -alpha off -fuzz 20% -format '%@\n' info: | tr 'x+' '  '
}

# expect_drawn FILE WIDTH HEIGHT: within three pixels, in the middle
expect_drawn() {
    local width height left top full_width full_height
    read -r width height left top < <(drawn "$1")
    read -r full_width full_height < <(identify -format '%w %h\n' "$1")
    ((width >= $2 - 3 && width <= $2 + 3 && height >= $3 - 3 && height <= $3 + 3)) ||
        fail "$1 shows something of ${width}x$height instead of $2x$3"
    ((2 * left + width - full_width <= 4 && full_width - 2 * left - width <= 4 &&
        2 * top + height - full_height <= 4 && full_height - 2 * top - height <= 4)) || fail "$1 is not in the middle"
}

# box FILE X Y Z: a closed box of this size, far from the origin
box() {
    awk -v x="$2" -v y="$3" -v z="$4" 'BEGIN {
        print "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z"
        print "element face 6\nproperty list uchar int vertex_indices\nend_header"
        for (i = 0; i < 8; ++i) print 50 + x * (i % 2), 20 + y * (int(i / 2) % 2), z * int(i / 4)
        print "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5"
    }' >"$1"
}

torus "$WORK/torus.ply"
take "$WORK/drawing.png" "$WORK/torus.ply"
expect_picture "$WORK/drawing.png" 500x400
ink=$(dark_pixels "$WORK/drawing.png")
((ink > 1000 && ink < 40000)) || fail "$ink dark pixels are no drawing"
[[ $(convert "$WORK/drawing.png" -format '%[pixel:p{2,2}]' info:) =~ white|255,255,255 ]] || fail "the paper is not white"

# take_with SETTING...: with_settings.png
take_with() {
    write_settings "$LAPLACIAN_LINES_BUILD" "$WORK/settings" "$@"
    take "$WORK/with_settings.png" "$WORK/torus.ply"
    rm "$WORK/settings"
}
take_with "Drawing Style=Publication"
expect_same_picture "$WORK/drawing.png" "$WORK/with_settings.png" 0
take_with "Line Color=red" "Contour Color=red" "Line Width=4"
(($(red_pixels "$WORK/with_settings.png") > 3 * ink / 2)) || fail "the lines are not red and wide"

gzip --keep "$WORK/torus.ply"
take "$WORK/sheet.png" "$WORK/torus.ply.gz" --view 30,15 --view -60,0
read -r width height < <(identify -format '%w %h\n' "$WORK/sheet.png")
((width == 2 * 516 && height > 416)) || fail "the sheet is ${width}x$height"
((2 * ink < 3 * $(dark_pixels "$WORK/sheet.png"))) || fail "the sheet holds less than two drawings"

# names that are no UTF-8, in any locale
odd=$'caf\xe9 @%w.'
cp "$WORK/torus.ply" "$WORK/${odd}ply"
for locale in C C.UTF-8; do
    LC_ALL=$locale take "$WORK/${odd}png" "$WORK/${odd}ply"
    expect_same_picture "$WORK/drawing.png" "$WORK/${odd}png" 0
    LC_ALL=$locale take "$WORK/odd_$locale.png" "$WORK/${odd}ply" --view front --view top
    rm "$WORK/${odd}png"
done
expect_same_picture "$WORK/odd_C.png" "$WORK/odd_C.UTF-8.png" 0

# without perspective, a box shows the two sizes that the view and the axis that is up leave, as large as they fit into
# 360 pixels: a twentieth of the shorter side is left free
box "$WORK/box.ply" 4 3 2
# expect_faces OPTIONS... -- WIDTH HEIGHT VIEW...: of the box in square pictures, which a sheet leaves in its folder
expect_faces() {
    local options=(--size 400x400 --orthographic) views=() sizes=() number
    while [[ $1 != -- ]]; do
        options+=("$1")
        shift
    done
    shift
    while (($#)); do
        sizes+=("$1 $2")
        views+=(--view "$3")
        shift 3
    done
    take "$WORK/faces.png" "$WORK/box.ply" "${options[@]}" "${views[@]}"
    for number in "${!sizes[@]}"; do
        # shellcheck disable=SC2086 # two numbers
        expect_drawn "$WORK/drawings/drawing_0_${number}_0.png" ${sizes[number]}
    done
}
expect_faces -- 360 270 front 360 270 180,0 240 360 left 360 180 top 360 180 bottom 180 360 90,90
expect_faces --up z -- 360 180 front 360 270 top
expect_faces --up x -- 270 360 back 180 360 right
expect_faces --zoom 0.5 -- 180 135 front 90 180 90,90
# in perspective, the front of the box hides the rest: it has its proportions, and there is more air around it
take "$WORK/face.png" "$WORK/box.ply" --size 400x400 --view back --zoom 0.5
read -r width height _ < <(drawn "$WORK/face.png")
((width > 160 && width <= 184 && 4 * height > 3 * width - 16 && 4 * height < 3 * width + 16)) ||
    fail "in perspective, the back is ${width}x$height"

# above 900 pixels, lines are as much wider as the shorter side is longer, so that a drawing of twice the size has four times the ink
# share_of_ink FILE
share_of_ink() {
    convert "$1" -alpha off -colorspace gray -negate -format '%[fx:mean]' info:
}
take "$WORK/small.png" "$WORK/torus.ply" --size 900x900
take "$WORK/large.png" "$WORK/torus.ply" --size 1800x1800
awk -v small="$(share_of_ink "$WORK/small.png")" -v large="$(share_of_ink "$WORK/large.png")" \
    'BEGIN { exit !(large > 0.85 * small && large < 1.15 * small) }' || fail "large drawings have lines of other proportions"
