#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Documents have OpenGL objects of their own: lines are drawn in each, and in those that are left when one is closed.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

torus "$WORK/torus.ply"
write_bumpy_torus 120 60 >"$WORK/ring.ply"
drive_lines torus.ply <<END
expect-lines
trigger New Empty Project...
open ring.ply
$(show_lines)
expect-lines
setdeco Least Facing = 0
expect-lines least_facing=0
trigger Close Project
sleep 100
expect-lines least_facing=0
drag 0.4 0.4 0.6 0.5
expect-lines least_facing=0
trigger Close Project
trigger New Empty Project...
open ring.ply
$(show_lines)
expect-lines least_facing=0
END
