#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./run takes as options of a picture, and what it says of others, before anything is built.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../run")

# refuses REASON ARGS...
refuses() {
    local code=0 said
    said=$(DISPLAY='' "$run" "${@:2}" 2>&1) || code=$?
    [[ $code == 1 && $said =~ $1 ]] || {
        printf './run %s ended with %s and said: %s\n' "${*:2}" "$code" "$said"
        exit 1
    }
}

# accepts OPTIONS...: the complaint is about what follows
accepts() {
    refuses 'unknown option --end' --picture picture.png "$@" --end
}

for view in front back left right top bottom 0,0 30,15 -200.5,-90 0,90 0,90.0 10,-89.9 10,07; do
    accepts --view "$view"
done
for view in '' above 30 30,91 0,90.1 0,-100 0,900 30,15,2 'front top' '[front'; do
    refuses '--view needs front, back' --picture picture.png --view "$view"
done
refuses '--view needs' --picture picture.png --view
accepts --up x --up y --up z
for axis in '' w X -z xy; do
    refuses '--up needs the axis' --picture picture.png --up "$axis"
done
accepts --zoom 2 --zoom 0.1 --zoom 10 --orthographic --size 1x20000
for zoom in '' 0 0.09 11 -1 1e0 2x .; do
    refuses '--zoom needs a factor' --picture picture.png --zoom "$zoom"
done
accepts --kinds all --noise 0.2 --kinds ridges+valleys,log
for kinds in '' --noise; do
    refuses '--kinds needs names' --picture picture.png --kinds "$kinds"
done
for noise in '' 0 -1 2.1 x; do
    refuses '--noise needs a share' --picture picture.png --noise "$noise"
done
for size in '' 0x10 10 10x 1200X900; do
    refuses '--size needs WIDTHxHEIGHT' --picture picture.png --size "$size"
done
touch "$work/scene.mlp"
refuses 'a project opens in a window; for a picture, name its meshes' "$work/scene.mlp" # there is no display
refuses 'a project opens in a window' --picture picture.png "$work/scene.mlp"
for mode in --server --python; do
    refuses '--zoom goes with --picture' --zoom 2 "$mode"
done

# detail goes with the size of a picture; what the user sets comes later and wins, and kinds are compared at one kernel
# shellcheck source=/dev/null
source "$(dirname "$run")/scripts/require.sh" product/picture
MESH_FILES=(mesh.ply) MESH_NOISES=("") PICTURE_VIEWS=("") DRAWINGS=$work
printf 'setdeco Scale = As Computed\n' >"$work/settings"
script=$(drawing_script 0 "$work")
[[ $script == *"Scale = With the View"*"Scale = As Computed"* ]] || fail "the user's Scale does not count: $script"
PICTURE_KINDS=all
script=$(drawing_script 0 "$work")
[[ $script != *"With the View"* ]] || fail "kinds have kernels of their own: $script"
