#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# others.sh PROGRAM: how ezdxf, vpype and svgpathtools read what the program of drawings writes.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=/dev/null
source "$here/../../scripts/require.sh" environment/messages hosts/drawing_tools product/models
# shellcheck source=/dev/null
source "$here/made_meshes.sh"

program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ensure_drawing_tools || skip "$OBSTACLE"

cd "$folder"
write_cube
write_bumpy_torus 160 80 >torus.ply
for scale in 1:1 1:2; do
    for ending in svg dxf; do
        "$program" "cube_$scale.$ending" --views front,left,top --strokes plain --furniture none --paper a2 \
            --scale $scale cube.off >/dev/null
    done
done
"$program" torus.svg --views front,30,25 --strokes plain --furniture none --paper fit --scale 50:1 torus.ply >/dev/null
"$DRAWING_PYTHON" -B "$here/others.py" "$folder"
echo passed
