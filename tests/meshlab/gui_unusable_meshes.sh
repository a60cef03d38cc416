#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A mesh without a surface has no lines, and the reason is in the log: points alone, nothing at all, no area, no finite
# vertices. With a surface again, it has lines again.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# ply NAME VERTICES FACES: an ASCII file with the vertices and faces on stdin
ply() {
    printf 'ply\nformat ascii 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' "$2"
    printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' "$3"
    cat
}

# try_lines NAME [COMMAND...]: the decoration refuses to go on; the commands answer what MeshLab asks on opening
try_lines() {
    local name=$1
    shift
    printf 'open %s.ply\n' "$name"
    printf '%s\n' "$@"
    printf 'check Laplacian Lines on\nexpect-log Laplacian Lines: %s.ply: %s\n' "$name" "$NO_SURFACE"
    printf 'expect-action Laplacian Lines unchecked\nexpect-no-lines\ntrigger Delete Current Mesh\n'
}

NO_SURFACE='The mesh has no triangle with an area'
ply points 3 0 <<<$'0 0 0\n1 0 0\n0 1 0' >"$WORK/points.ply"
ply flat 3 2 <<<$'0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n3 1 1 2' >"$WORK/flat.ply"
ply nan 3 1 <<<$'nan 0 0\n1 nan 0\n2 0 1\n3 0 1 2' >"$WORK/nan.ply"
torus "$WORK/torus.ply"
drive_lines torus.ply <<END
expect-lines
trigger Delete ALL Faces
apply
close
expect-log Laplacian Lines: torus.ply: $NO_SURFACE.* reconstruct one first
expect-no-lines
drag 0.5 0.5 0.6 0.6
expect-no-log (torus.ply: $NO_SURFACE(.*\n)*.*){2}
trigger Compute Laplacian Lines
expect-modal PreConditions' Failure.* does not have .*Faces
button OK
trigger Reload
expect-lines
trigger Select All
apply
close
trigger Delete Selected Vertices
expect-log (torus.ply: $NO_SURFACE(.*\n)*.*){2}
expect-no-lines
drag 0.5 0.5 0.6 0.6
trigger Laplacian Smooth
button OK
expect-no-lines
trigger Reload
expect-lines
check Laplacian Lines off
trigger Delete Current Mesh
$(try_lines points)
$(try_lines flat "expect-modal 0 vertices with NAN coords and 1 degenerated" "button OK")
$(try_lines nan "expect-modal 2 vertices with NAN coords" "button OK")
open torus.ply
check Laplacian Lines on
check Laplacian Lines Probe on
expect-lines
END
