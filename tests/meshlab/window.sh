#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run opens several meshes and projects in one window, each layer with its lines, whatever their files are called; of
# what cannot be opened it says which one and why.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/window

# open_and_expect CODE NAME... -- COMMAND...: a window of these, in which the driver then does this
open_and_expect() {
    local expected=$1 code=0 names=()
    shift
    while [[ $1 != -- ]]; do
        names+=("$1")
        shift
    done
    rm -rf "$WORK/window"
    mkdir "$WORK/window"
    printf '%s\n' "${@:2}" quit >"$WORK/window/settings"
    (open_window "$STAGE" "$WORK/window" "${names[@]}") 2>"$WORK/said" || code=$?
    cp "$WORK/window/log" "$WORK/log" || true
    ((code == expected)) || fail "it ended with $code instead of $expected: $(<"$WORK/said")"
}

# lines_of_layers COUNT: the commands that look at each layer's lines alone
lines_of_layers() {
    local layer
    printf '%s\n' 'check Show Info Panel off' 'check Show Trackball off' 'size 500x400' 'setdeco Line Color = #ff0000' \
        'setdeco Contour Color = #ff0000' 'slot view resetTrackBall'
    for ((layer = 0; layer < $1; ++layer)); do
        printf '%s\n' "select-layer $layer" 'check Laplacian Lines Probe on'
    done
    printf 'expect-lines\n'
    for ((layer = 0; layer < $1 - 1; ++layer)); do
        printf '%s\n' "show-layer $layer" expect-lines
    done
    printf '%s\n' "show-layer $layer" expect-no-lines
}

small_torus "$WORK/torus.ply"
mkdir "$WORK/odd"
odd="it's \"a & b\" ü %1 \$HOME.ply"
write_bumpy_torus 30 20 >"$WORK/odd/$odd"
latin=odd/$'caf\xe9\n.ply'
write_bumpy_torus 20 20 >"$WORK/$latin"
gzip -c "$WORK/torus.ply" >"$WORK/packed.ply.gz"
cd "$WORK" || exit
mapfile -t commands < <(lines_of_layers 4)
open_and_expect 0 torus.ply "odd/$odd" "$latin" packed.ply.gz -- "${commands[@]}"
grep -F "Laplacian Lines: $odd has no precomputed attributes" log | grep -qE ' options in [0-9.]+ s' ||
    fail "a name changes what the log says"

# project FILE MESH...
project() {
    local file=$1 mesh
    shift
    {
        printf '<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n <MeshGroup>\n'
        for mesh in "$@"; do
            mesh=${mesh//&/\&amp;}
            mesh=${mesh//</\&lt;}
            mesh=${mesh//\"/\&quot;}
            printf '  <MLMesh label="%s" filename="%s"><MLMatrix44>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MLMatrix44></MLMesh>\n' \
                "$mesh" "$mesh"
        done
        printf ' </MeshGroup>\n <RasterGroup/>\n</MeshLabProject>\n'
    } >"$file"
}

scene="odd/a \"scene\" & more ü.mlp"
project "$scene" ../torus.ply "$odd"
mapfile -t commands < <(lines_of_layers 2)
open_and_expect 0 "$scene" -- "${commands[@]}"
mapfile -t commands < <(lines_of_layers 3)
open_and_expect 0 "$scene" torus.ply -- "${commands[@]}"

printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' >point.ply
project points.mlp point.ply torus.ply
open_and_expect 0 points.mlp -- 'expect-action Laplacian Lines checked' 'select-layer 0' \
    'expect-action Laplacian Lines unchecked' 'expect-log point.ply: The mesh has no triangle'

project incomplete.mlp torus.ply missing.ply
open_and_expect 1 torus.ply incomplete.mlp --
expect_text said 'incomplete.mlp: MeshLab cannot open the project: .*missing.ply'
printf 'no project\n' >broken.mlp
open_and_expect 1 broken.mlp --
expect_text said 'broken.mlp: MeshLab cannot open the project'
open_and_expect 1 torus.ply broken.mlp --
expect_text said 'broken.mlp: MeshLab cannot open the project'
printf 'no mesh\n' >broken.ply
open_and_expect 1 torus.ply broken.ply --
expect_text said 'broken.ply: MeshLab cannot read it'
touch $'odd\n.mlp'
! (open_window "$STAGE" "$WORK/window" $'odd\n.mlp') 2>said || fail "a name that is a command was taken"
expect_text said 'rename it or its folder'
