#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# One choice makes a drawing in black on white, whatever else is set, in any render mode and with several layers; taking
# it back leaves the view as it was.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

publication() { printf 'setdeco Drawing Style = Publication (Black on White)\n'; }
as_set_below() { printf 'setdeco Drawing Style = Custom\n'; }

# styles NAME: as it was, the drawing, and as it was again
styles() {
    printf 'grab %s.png\n' "$1"
    publication
    printf 'grab %s_publication.png\n' "$1"
    as_set_below
    printf 'grab %s_again.png\n' "$1"
}

# expect_corner FILE COLOUR: of a pixel in it
expect_corner() {
    local color
    color=$(convert "$WORK/$1" -format '%[hex:u.p{9,9}]' info:)
    [[ ${color,,} == "$2" ]] || fail "the corner of $1 is $color instead of $2"
}

# colors FILE: how many pixels have a colour of their own
colors() {
    convert "$WORK/$1" -alpha off -colorspace HSL -channel G -separate -threshold 1% -format '%[fx:round(mean*w*h)]' info:
}

# expect_drawing FILE: grey strokes on pure white, of which there are many
expect_drawing() {
    local white
    (($(colors "$1") == 0)) || fail "$(colors "$1") pixels of $1 are not grey"
    white=$(convert "$WORK/$1" -alpha off -fill black +opaque white -format '%[fx:mean]' info:)
    awk "BEGIN { exit !($white > 0.8 && $white < 0.995) }" || fail "$white of $1 is white"
    expect_corner "$1" ffffff
}

sed -i '/background...Color/d' "$HOME/.config/VCG/MeshLab_64bit_fp.conf"
set_colour "$HOME" backgroundBotColor 40 0 80
set_colour "$HOME" backgroundTopColor 0 90 20
torus "$WORK/torus.ply"
write_bumpy_torus 120 60 >"$WORK/ring.ply"
drive_lines torus.ply <<END
look 2.2 0.8 2.2  0 0 0
setdeco Paper Color = #ffee00
$(styles fill)
gl-state before.txt
$(publication)
gl-state drawing.txt
$(as_set_below)
check Wireframe on
$(styles wireframe_on_fill)
check Fill off
$(styles wireframe)
check Points on
check Wireframe off
$(styles points)
check Fill on
check Points off
trigger Toggle Orthographic Camera
$(styles orthographic)
trigger Toggle Orthographic Camera

# nothing of the drawing is left out when there are no lines
setdeco Laplacian Lines = off
setdeco Ridges = off
setdeco Occluding Contours = off
$(publication)
grab bare.png
setdeco Laplacian Lines = on
setdeco Ridges = on
setdeco Occluding Contours = on
grab by_style.png
snapshot tiled.png 2
snapshot transparent.png 1 transparent
$(as_set_below)

# the same by hand, with a background of one's own
setdeco Surface = Paper
setdeco Background = Paper Color
grab yellow.png
setdeco Paper Color = #ffffff
setdeco Line Color = #000000
setdeco Contour Color = #000000
grab by_hand.png
setdeco Background = As MeshLab Draws It
setdeco Surface = As MeshLab Draws It
setdeco Paper Color = #ffee00

# the lines are the core's, and for archaeologists those of a light on the upper left
ink #000000
$(publication)
expect-lines
setdeco Drawing Style = Archaeology (Side Light)
expect-lines light_x=-0.5 light_y=0.5 light_z=0.70711
expect-other-lines
grab archaeology.png
setdeco Light Azimuth = 90
expect-other-lines light_x=-0.5 light_y=0.5 light_z=0.70711
setdeco Light Azimuth = 315
$(as_set_below)

# a second layer erases nothing of the first
open ring.ply
select-layer ring
$(move_layer 'X Translation = 1.1' 'X Rotation = 80' 'X Scale = 0.8' 'Y Scale = 0.8' 'Z Scale = 0.8')
check Laplacian Lines on
check Laplacian Lines Probe on
slot view resetTrackBall
$(styles two_layers)
$(publication)
expect-lines
END

for view in fill wireframe_on_fill wireframe points orthographic two_layers; do
    expect_same_picture "$WORK/$view.png" "$WORK/${view}_again.png" 0
done
diff "$WORK/before.txt" "$WORK/drawing.txt" || fail "the drawing changes OpenGL's state"
for view in fill wireframe_on_fill wireframe orthographic two_layers; do
    expect_drawing "${view}_publication.png"
    (($(colors "$view.png") > 200000)) || fail "$view.png has little colour to be taken away"
done
expect_drawing tiled.png
expect_drawing archaeology.png
# points stand out of the outline
expect_corner points_publication.png ffffff
(($(colors points_publication.png) < 4500)) || fail "$(colors points_publication.png) pixels among points are not grey"
expect_corner yellow.png ffee00
expect_same_picture "$WORK/by_style.png" "$WORK/by_hand.png" 0
# paper around the form does not fill a snapshot that is to have no background; paper on it stays
alpha=$(convert "$WORK/transparent.png" -alpha extract -format '%[fx:u.p{9,9}] %[fx:maxima] %[fx:mean > 0.1 && mean < 0.4]' info:)
[[ $alpha == '0 1 1' ]] || fail "transparent.png has alpha $alpha at the corner, at most, and in the middle"
(($(convert "$WORK/bare.png" -alpha off -fill black -opaque white -fill white +opaque black -format '%[fx:round(mean*w*h)]' info:) == 0)) ||
    fail "bare.png is not white all over"
