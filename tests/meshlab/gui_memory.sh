#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Nothing piles up in memory, and when there is not enough of it, MeshLab says so and goes on.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# times N LINE...: the lines, N times over
times() {
    local count=$1 i
    shift
    for ((i = 0; i < count; ++i)); do
        printf '%s\n' "$@"
    done
}

# What is prepared for the lines of this torus takes 1 MB: one that is lost at each toggle would make 50 MB. MeshLab
# keeps 3 MB at each run of any filter; ours must not keep more than one of its own.
small_torus "$WORK/torus.ply"
drive <<END
wait
open torus.ply
size 500x400
$(times 10 "check Laplacian Lines on" "check Laplacian Lines off")
note-memory
$(times 50 "check Laplacian Lines on" "check Laplacian Lines off")
expect-memory-growth 6
check Laplacian Lines on
trigger Compute Laplacian Lines
apply
close
trigger Per Vertex Color Function
$(times 5 "apply")
note-memory
$(times 20 "apply")
allow-memory-growth
close
trigger Compute Laplacian Lines
$(times 20 "apply")
expect-memory-growth 6
close
note-memory
$(times 25 "drag 0.3 0.3 0.5 0.5" "drag 0.5 0.5 0.3 0.3")
expect-memory-growth 6
END
grep 'has grown' "$WORK/log"
