#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Paper and toon cover what MeshLab draws of a layer, in any render mode, and leave no trace when they are off.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# papers NAME: with lines, without lines, in two tones, and as it was before
papers() {
    cat <<END
grab $1.png
setdeco Surface = Paper
grab $1_paper.png
setdeco Laplacian Lines = off
setdeco Ridges = off
setdeco Occluding Contours = off
grab $1_bare.png
setdeco Surface = Toon
grab $1_toon.png
setdeco Laplacian Lines = on
setdeco Ridges = on
setdeco Occluding Contours = on
setdeco Surface = As MeshLab Draws It
grab $1_again.png
END
}

# pixels_other_than FILE COLOUR...: how many there are
pixels_other_than() {
    local picture=$1 color edits=()
    shift
    for color in "$@"; do edits+=(-fill black -opaque "$color"); done
    convert "$WORK/$picture" -alpha off "${edits[@]}" -fill white +opaque black -colorspace gray \
        -format '%[fx:round(mean*w*h)]' info:
}

# specks_inside FILE: pixels of other colours than paper where fill_bare.png has paper
specks_inside() {
    convert \( "$WORK/$1" -alpha off -fill black -opaque '#ffee00' -fill white +opaque black \) \
        \( "$WORK/fill_bare.png" -alpha off -fill black +opaque '#ffee00' -fill white -opaque '#ffee00' \) \
        -compose Multiply -composite -colorspace gray -format '%[fx:round(mean*w*h)]' info:
}

# expect_at_most PIXELS FILE COLOUR...: so many have another colour
expect_at_most() {
    local most=$1 others
    shift
    others=$(pixels_other_than "$@")
    ((others <= most)) || fail "$1 has $others pixels that are neither of ${*:2}, more than $most"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
look 2.2 0.8 2.2  0 0 0
setdeco Surface = Toon
setdeco Paper Color = #ffee00
setdeco Tones = 2
setdeco Surface = As MeshLab Draws It
$(papers fill)
check Wireframe on
$(papers wireframe_on_fill)
check Fill off
$(papers wireframe)
check Points on
check Wireframe off
$(papers points)
check Fill on
check Points off
trigger toon.gdp
$(papers shader)
setdeco Surface = Paper
expect-lines
trigger Toggle Orthographic Camera
expect-lines
END
for mode in fill wireframe_on_fill wireframe points shader; do
    expect_same_picture "$WORK/$mode.png" "$WORK/${mode}_again.png" 0
    # what stands out of the outline is not covered: points are three pixels wide
    case $mode in
        fill | shader) outside=0 ;;
        points) outside=4500 ;;
        *) outside=1500 ;;
    esac
    expect_at_most "$outside" "${mode}_bare.png" white '#ffee00'
    # but at folds within it
    (($(specks_inside "${mode}_bare.png") <= 20)) || fail "${mode}_bare.png has specks on the paper"
    # yellow and a shade of it, blended where they meet
    expect_at_most $((outside + 6500)) "${mode}_toon.png" white '#ffee00' '#968c00'
    (($(pixels_other_than "${mode}_toon.png" white '#ffee00') > 3000)) || fail "no shade in mode $mode"
    expect_same_picture "$WORK/fill_paper.png" "$WORK/${mode}_paper.png" $((2 * outside))
done
