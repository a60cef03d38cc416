#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines that are switched off and on again are there at once: nothing is computed again while the mesh is the same, and
# for kinds that need more only that. Their memory goes with the mesh, and with its document.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# whose lines take 16 MB; from 2022.02 on, MeshLab itself keeps 29 to 33 MB of a layer that is deleted
own_growth=0
[[ $(meshlab_version) == 2020.* ]] || own_growth=34
write_bumpy_torus 400 150 >"$WORK/torus.ply"
small_torus "$WORK/small.ply"
drive_lines torus.ply <<END
size 1200x860
expect-lines
check Laplacian Lines off
expect-no-lines
sleep 50
check Laplacian Lines on
expect-lines
expect-no-log torus.* computed with the default(.*\n)*.*torus.* computed with the default
# what only some kinds of lines need is computed when they are switched on, and nothing else
expect-no-log need besides
watch-drawings
setdeco Suggestive Contours = on
expect-log torus.*: computed in .* need besides
expect-true-drawings
setdeco Suggestive Contours = off
setdeco Demarcating Curves = on
expect-true-drawings
setdeco Demarcating Curves = off
expect-no-log torus.* computed with the default(.*\n)*.*torus.* computed with the default
expect-no-log need besides(.*\n)*.*need besides
# nor in another view
trigger Horizontally
view 0
check Laplacian Lines off
sleep 50
view 1
$(show_lines)
expect-lines
expect-no-log torus.* computed with the default(.*\n)*.*torus.* computed with the default
check Laplacian Lines off
sleep 50
trigger Close current view
view 0
# another geometry is another matter
trigger Laplacian Smooth
apply
close
check Laplacian Lines on
expect-log torus.* computed with the default(.*\n)*.*torus.* computed with the default
expect-lines
check Laplacian Lines off

# what is kept is freed with its document
trigger New Empty Project...
open small.ply
$(show_lines)
expect-lines
note-memory
trigger New Empty Project...
open torus.ply
$(show_lines)
expect-lines
check Laplacian Lines off
trigger Close Project
sleep 100
expect-memory-growth 6

# and with its mesh
document 1
open torus.ply
select-layer torus
check Laplacian Lines on
check Laplacian Lines off
sleep 50
delete-layer torus
sleep 50
expect-memory-growth $((own_growth + 6))
END
grep 'has grown' "$WORK/log"
