#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Edit tools move vertices without telling decorations: the redraw that follows shows the lines of the new shape. If the
# camera moves before it, without a key or button between, one that comes by itself does.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

small_torus "$WORK/small.ply"
write_bumpy_torus 420 240 >"$WORK/large.ply" # 302,400 vertices and faces

# edits MESH
edits() {
    drive <<END
wait
open $1
size 500x400
check Laplacian Lines on
watch-drawings
# the first redraw takes long: what it has to show is computed
together redraw ; redraw ; stretch 1.2 ; redraw ; expect-true-drawings
# a key or button tells that the camera may not be all that has moved
together redraw ; stretch 1.1 ; press-key ; look 1 4 3 0 0 0 ; redraw ; expect-true-drawings
time-limit 15
together redraw ; stretch 0.8 ; look 0 2 5 0 0 0 ; forget-drawings
await-true-drawing
# nothing is redrawn without end
sleep 700
forget-drawings
sleep 700
expect-no-drawings
END
}

edits small.ply
edits large.ply
