#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab's snapshots have the lines. Those put together from tiles, which show a part of the camera's view each, are the
# picture of a view so much larger, with lines so much wider: then the print looks like the view.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# Visibility is that of the view, which looks at fewer pixels beside a line than a larger one; that is a few hundred pixels.
most_differing=2000

# larger NAME FACTOR: what a snapshot of FACTOR by FACTOR tiles has to look like
larger() {
    cat <<END
size $((400 * $2))x$((300 * $2))
setdeco Line Width = $(awk "BEGIN { print 1.6 * $2 }")
grab $1.png
setdeco Line Width = 1.6
size 400x300
END
}

# snapshots NAME: in three sizes
snapshots() {
    local tiles
    echo "grab $1.png"
    for tiles in 1 2 3; do
        echo "snapshot $1_$tiles.png $tiles"
    done
    echo "grab $1_again.png"
}

# expect_same_width NAME TILES: lines are as wide in the view as in the snapshot brought down to its size. Without their
# widths growing it would have a half or a third of the red.
expect_same_width() {
    local view print
    view=$(redness "$1.png")
    print=$(redness "$1_$2.png")
    ((view * 96 <= print * 100 && print * 96 <= view * 100)) ||
        fail "the lines have $view of the view $1, but $print of the snapshot of $2 by $2 tiles"
}

# redness FILE: share of the picture that is red and neither white nor grey, in 1/100000
redness() {
    convert "$WORK/$1" -alpha off -format '%[fx:round((mean.r-mean.g)*100000)]' info:
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
size 400x300
look 2.2 0.5 2.2  0 0 0
expect-lines
$(snapshots perspective)
$(larger perspective_view_2 2)
$(larger perspective_view_3 3)
expect-lines
# another camera, not drawn before
look 1.9 0.9 2.2  0 0 0
snapshot unseen.png 2
$(larger unseen_view 2)
trigger Toggle Orthographic Camera
$(snapshots orthographic)
$(larger orthographic_view_2 2)
$(larger orthographic_view_3 3)
trigger Toggle Orthographic Camera
check Points on
check Fill off
setdeco Surface = Paper
setdeco Hidden Lines = Dashed
$(snapshots dashed)
END
# A camera that differs in the last bits may have other points of a line left out, which changes its tone by a shade.
for view in perspective orthographic dashed; do
    expect_same_picture "$WORK/$view.png" "$WORK/${view}_1.png" 150
    expect_same_picture "$WORK/$view.png" "$WORK/${view}_again.png" 10
    for tiles in 2 3; do
        expect_same_width "$view" "$tiles"
    done
done
for view in perspective orthographic; do
    for tiles in 2 3; do
        expect_same_picture "$WORK/${view}_view_$tiles.png" "$WORK/${view}_$tiles.png" "$most_differing"
    done
done
expect_same_picture "$WORK/unseen_view.png" "$WORK/unseen.png" "$most_differing"
