#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLab's snapshots have the lines, also when put together from tiles that show a part of the camera's view each: then
# the picture is that of a larger view.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
drive_lines torus.ply <<'END'
size 400x300
look 2.2 0.5 2.2  0 0 0
expect-lines
grab view.png
snapshot one.png 1
snapshot four.png 2
snapshot nine.png 3
expect-lines
size 800x600
expect-lines
grab view_for_four.png
size 1200x900
expect-lines
grab view_for_nine.png
size 400x300
trigger Toggle Orthographic Camera
snapshot orthographic_nine.png 3
size 1200x900
expect-lines
grab view_for_orthographic_nine.png
END
expect_same_picture "$WORK/view.png" "$WORK/one.png" 0
# where tiles meet, MeshLab's own drawing may differ a little
for tiles in four nine orthographic_nine; do
    expect_same_picture "$WORK/view_for_$tiles.png" "$WORK/$tiles.png" 500
done
