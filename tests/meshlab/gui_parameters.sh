#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The view follows each parameter of the decoration; one that is out of range stays as it was last, and the log says so.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# change LABEL KEY VALUE DEFAULT: the lines with this value, seen to differ from the default ones
change() {
    printf 'setdeco %s = %s\nexpect-lines %s=%s\nexpect-other-lines\nsetdeco %s = %s\n' "$1" "$3" "$2" "$3" "$1" "$4"
}

# refuse LABEL BAD GOOD REASON: the lines of the last good value and the reason in the log
refuse() {
    printf 'setdeco %s = %s\nexpect-lines\nexpect-log %s\nsetdeco %s = %s\nexpect-lines\n' "$1" "$2" "$4" "$1" "$3"
}

# expect_ink A B FACTOR: picture B has at least FACTOR times as much of the lines' red as A
expect_ink() {
    local a b
    a=$(red_pixels "$WORK/$1")
    b=$(red_pixels "$WORK/$2")
    awk "BEGIN { exit !($a > 0 && $b >= $3 * $a) }" || fail "$2 has $b red pixels, $1 has $a"
}

torus "$WORK/torus.ply"
drive_lines torus.ply <<END
look 1.5 0.5 1.5  0 0 0
expect-lines
$(change "Strength Threshold tau" strength_threshold 0.5 0.01)
$(change "Gradient Threshold t" gradient_threshold 10 0.8)
$(change "Least Slope of a Segment" segment_slope 0.2 0.004)
$(change "Least Slope of a Line" line_slope 0.3 0.012)
$(change "Shortest Line" shortest_line 0.3 0.01)
$(change "Shortest Contour" shortest_contour 10 0.005)
$(change "Least Facing" least_facing 0.5 -0.15)
setdeco Single Strokes = off
expect-lines single_strokes=0
expect-other-lines
setdeco Single Strokes = on
$(change "Ridge Angle" ridge_angle 40 10)
setdeco Mesh Silhouettes = on
expect-lines mesh_silhouettes=1
setdeco Mesh Silhouettes = off
setdeco Crease Angle = 20
expect-lines crease_angle=20
setdeco Crease Angle = 40
setdeco Creases = off
expect-lines creases=0
setdeco Creases = on
$(change "Line Smoothing" line_smoothing 10 1.2)
expect-lines
setdeco Least Slope of a Segment = 0
setdeco Least Slope of a Line = 0
setdeco Gradient Threshold t = 0
expect-lines segment_slope=0 line_slope=0 gradient_threshold=0
setdeco Single Strokes = off
setdeco Reject Phantom Lines = off
expect-lines segment_slope=0 line_slope=0 gradient_threshold=0 single_strokes=0 reject_phantoms=0
expect-other-lines segment_slope=0 line_slope=0 gradient_threshold=0 single_strokes=0
setdeco Reject Phantom Lines = on
setdeco Single Strokes = on
setdeco Least Slope of a Segment = 0.004
setdeco Least Slope of a Line = 0.012
setdeco Gradient Threshold t = 0.8

setdeco Exact Point Light = on
expect-lines exact_point_light=1
expect-other-lines
setdeco Exact Point Light = off
setdeco Occluding Contours = off
expect-lines contours=0
expect-other-lines
setdeco Laplacian Lines = off
setdeco Ridges = off
expect-no-lines
setdeco Occluding Contours = on
expect-lines laplacian_lines=0 ridges=0
expect-other-lines
setdeco Laplacian Lines = on
setdeco Ridges = on

setdeco Line Width = 2
grab narrow.png
setdeco Line Width = 5
grab wide.png
setdeco Line Width = 2
setdeco Contour Width Factor = 3
grab wide_contours.png
setdeco Contour Width Factor = 1
setdeco Slope for Full Width = 10
grab faint.png
setdeco Slope for Full Width = 0.25
setdeco Contour Width Factor = 0
expect-lines contours=0
setdeco Contour Width Factor = 1
setdeco Line Color = #0000ff
setdeco Contour Color = #0000ff
expect-no-lines
ink #0000ff
expect-lines
ink red
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000

$(refuse "Gradient Threshold t" -1 0.8 '"Gradient Threshold t" is -1\. It has to be between 0 and')
$(refuse "Strength Threshold tau" -0.5 0.01 '"Strength Threshold tau" is -0.5\. It has to be between 0 and')
$(refuse "Shortest Line" 11 0.01 '"Shortest Line" is 11\. It has to be between 0 and 10')
$(refuse "Slope for Full Width" 0 0.25 '"Slope for Full Width" is 0\. It has to be between 1e-06 and')
$(refuse "Least Facing" 1.5 -0.15 '"Least Facing" is 1.5\. It has to be between -1 and 1')
# not the default, and other parameters count meanwhile
setdeco Gradient Threshold t = 10
setdeco Gradient Threshold t = -1
expect-log "Gradient Threshold t" is -1\. It has to be between 0 and [^.]*\. Until then it stays 10\.
expect-lines gradient_threshold=10
expect-other-lines
setdeco Shortest Line = 0.3
expect-lines gradient_threshold=10 shortest_line=0.3
setdeco Shortest Line = 0.01
setdeco Gradient Threshold t = 0.8
expect-lines
# a decimal comma
setdeco Strength Threshold tau = 0,5
expect-lines strength_threshold=0.5
expect-other-lines
setdeco Strength Threshold tau = 0.01
# and again, because it was all right in between
$(refuse "Gradient Threshold t" -1 0.8 '("Gradient Threshold t" is -1\.(.*\n)*.*){2}')
$(refuse "Gradient Threshold t" nan 0.8 '"Gradient Threshold t" is not a number\. It has to be between 0 and')
$(refuse "Strength Threshold tau" a,b 0.01 '"Strength Threshold tau" is not a number\. It has to be between 0 and')

# and again, because a filter's preview takes what was said since its dialog opened out of the log
trigger Laplacian Smooth
setdeco Gradient Threshold t = -3
expect-log "Gradient Threshold t" is -3\.
set Preview = on
expect-log "Gradient Threshold t" is -3\.
set Preview = off
close
setdeco Gradient Threshold t = 0.8
expect-lines
END

# a line takes its width in the picture; contours and faint lines their own
expect_ink narrow.png wide.png 1.8
expect_ink narrow.png wide_contours.png 1.2
expect_ink faint.png narrow.png 1.2
