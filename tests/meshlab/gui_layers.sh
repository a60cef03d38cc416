#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Several layers: each has its own lines in its own place, also when layers move, hide, come and go.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
write_bumpy_torus 120 60 >"$WORK/ring.ply"
drive_lines torus.ply <<END
open ring.ply
select-layer ring
# a transformation that is not frozen: the ring links the torus like the next one of a chain, partly hidden by it
$(move_layer 'X Translation = 1.1' 'X Rotation = 80' 'Y Rotation = 20' 'X Scale = 0.8' 'Y Scale = 0.8' 'Z Scale = 0.8')
# the torus alone has lines
expect-lines
expect-no-log ring.* computed
check Laplacian Lines on
expect-log Laplacian Lines: ring.* computed
check Laplacian Lines Probe on
slot view resetTrackBall
expect-lines
drag 0.4 0.4 0.5 0.5
expect-lines
grab both.png
trigger Toggle Orthographic Camera
expect-lines
trigger Toggle Orthographic Camera

# lines of a hidden layer are hidden too, and those behind it appear
show-layer torus
expect-lines
grab ring.png
show-layer torus
expect-lines
show-layer ring
expect-lines
show-layer ring

# scales that differ by direction, and a mirror
select-layer ring
$(move_layer 'X Translation = 0.8' 'Y Rotation = 60' 'X Scale = -0.5' 'Y Scale = 0.9' 'Z Scale = 1.3')
expect-lines
grab sheared.png
# frozen, it is another geometry at the same place
trigger Matrix: Freeze Current Matrix
apply
close
expect-lines
expect-log ring.* has (no precomputed attributes|changed).*\n(.*\n)*.*ring.* has (no precomputed attributes|changed)

# flattened by a transformation that has no inverse, a layer has no lines, and the others keep theirs
trigger Matrix: Set from translation/rotation/scale
set Freeze Matrix = off
set X Scale = 0
apply
expect-log Laplacian Lines: ring.*: The layer's transformation cannot be inverted
set X Scale = 1
apply
close
expect-lines

# MeshLab never says that a deleted layer's decoration ends, and hands out a null mesh instead
select-layer torus
delete-layer torus
expect-lines
setdeco Least Facing = 0.2
expect-lines least_facing=0.2
setdeco Least Facing = -0.15
trigger Laplacian Smooth
apply
close
expect-lines
open torus.ply
check Laplacian Lines on
check Laplacian Lines Probe on
expect-lines
select-layer ring
delete-layer ring
expect-lines
select-layer torus
delete-layer torus
expect-no-lines
open torus.ply
check Laplacian Lines on
check Laplacian Lines Probe on
expect-lines
END
