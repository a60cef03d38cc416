#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A sheet of ./run --picture is made without the meshes that fail, each of which is named with its reason, and ends with
# an error. What MeshLab mends when it opens a mesh is not a failure.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/picture
stop_display # it starts one of its own

# ply FILE VERTICES FACES: with the vertices and faces on stdin
ply() {
    printf 'ply\nformat ascii 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' "$2" >"$1"
    printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' "$3" >>"$1"
    cat >>"$1"
}

# take CODE MESH...: expects this exit code; what is said is in $WORK/log
take() {
    local expected=$1 code=0
    shift
    rm -rf "$WORK/drawings" "$WORK/sheet.png"
    mkdir "$WORK/drawings"
    (
        trap stop_display EXIT
        PICTURE_SIZE=300x200
        take_pictures "$STAGE" "$WORK/drawings" "$WORK/sheet.png" "$@"
    ) 2>"$WORK/log" || code=$?
    ((code == expected)) || fail "it ended with $code instead of $expected"
}

# expect_drawings N: in a row
expect_drawings() {
    local width
    width=$(identify -format '%w' "$WORK/sheet.png")
    ((width == $1 * 316)) || fail "the sheet is $width pixels wide"
}

small_torus "$WORK/torus.ply"
ply "$WORK/points.ply" 3 0 <<<$'0 0 0\n1 0 0\n0 1 0'
ply "$WORK/mended.ply" 4 2 <<<$'0 0 0\n1 0 0\n0 1 0\n2 0 0\n3 0 1 2\n3 0 1 1'
printf 'not a mesh\n' >"$WORK/broken.ply"
printf 'not packed\n' >"$WORK/broken.ply.gz"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99999999\n' >"$WORK/crash.off" # has MeshLab read beyond the vertices

take 1 "$WORK/torus.ply" "$WORK/points.ply" "$WORK/mended.ply"
expect_drawings 2
expect_text "$WORK/log" "points.ply: The mesh has no triangle with an area. Laplacian lines need a surface: for a point cloud, reconstruct one first.$"
expect_text "$WORK/log" "not drawn: $WORK/points.ply$"

take 1 "$WORK/broken.ply" "$WORK/torus.ply" "$WORK/broken.ply.gz"
expect_drawings 1
expect_text "$WORK/log" "broken.ply: MeshLab cannot read it: "
expect_text "$WORK/log" "broken.ply.gz cannot be unpacked"

take 1 "$WORK/torus.ply" "$WORK/crash.off" "$WORK/torus.ply"
expect_drawings 2
expect_text "$WORK/log" "crash.off: MeshLab('s own reader of .off files has ended MeshLab| cannot read it)"

awk '/^end_header/ { vertices = NR + 2 } NR == vertices { $1 = "1e30" } { print }' "$WORK/torus.ply" >"$WORK/far.ply"
take 1 "$WORK/far.ply" "$WORK/torus.ply"
expect_drawings 1
expect_text "$WORK/log" "far.ply: a few vertices lie so far off that nothing could be seen of the rest; delete them$"

take 1 "$WORK/points.ply"
[[ ! -e $WORK/sheet.png ]] || fail "there is a picture of points"
expect_text "$WORK/log" "for a point cloud, reconstruct one first"
expect_text "$WORK/log" "no picture was written"

take 0 "$WORK/torus.ply" "$WORK/mended.ply"
expect_drawings 2
