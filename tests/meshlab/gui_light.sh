#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A light that is fixed to the camera: the lines are the core's for its direction and follow it while the view turns,
# and nothing else changes.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

upper_left='light_x=-0.5 light_y=0.5 light_z=0.70711'

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
look 1.5 0.5 1.5  0 0 0
grab at_the_eye.png
setdeco Laplacian Lines = off
setdeco Ridges = off
grab contours_at_the_eye.png
setdeco Light Position = Fixed to the Camera
grab contours_fixed.png
setdeco Laplacian Lines = on
setdeco Ridges = on
setdeco Light Position = At the Eye
grab at_the_eye_again.png
setdeco Light Position = Fixed to the Camera

# the upper left by default, whichever way one looks
expect-lines $upper_left
expect-other-lines
expect-other-lines light_x=0.5 light_y=0.5 light_z=0.70711
drag 0.5 0.5 0.7 0.62
expect-lines $upper_left
drag 0.4 0.3 0.2 0.6
expect-lines $upper_left
look 0.2 -1.8 -0.9  0 0 0  1 0.3 0
expect-lines $upper_left
trigger Toggle Orthographic Camera
expect-lines $upper_left

# clockwise from the top, and above the plane of the picture
setdeco Light Elevation = 0
setdeco Light Azimuth = 0
expect-lines light_y=1
setdeco Light Azimuth = 90
expect-lines light_x=1
setdeco Light Azimuth = 180
setdeco Light Elevation = 30
expect-lines light_y=-0.86603 light_z=0.5
setdeco Light Azimuth = -90
expect-lines light_x=-0.86603 light_z=0.5
expect-other-lines light_x=0.86603 light_z=0.5
# from behind an orthographic viewer, it is at the eye; there it lets lines go that double contours
setdeco Light Elevation = 90
expect-lines contour_clearance=0

# a layer that is stretched and mirrored is lit in the scene, not in its own coordinates
setdeco Light Azimuth = 315
setdeco Light Elevation = 45
$(move_layer 'X Rotation = 20' 'Y Rotation = 60' 'X Scale = -0.6' 'Y Scale = 1.2')
expect-lines $upper_left
setdeco Light Elevation = -1
expect-lines $upper_left
expect-log "Light Elevation" is -1\. It has to be between 0 and 90
setdeco Light Elevation = 45
setdeco Light Position = At the Eye
expect-lines
END
expect_same_picture "$WORK/contours_at_the_eye.png" "$WORK/contours_fixed.png" 0
expect_same_picture "$WORK/at_the_eye.png" "$WORK/at_the_eye_again.png" 0
