#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# others.sh PROGRAM: how ezdxf, vpype and svgpathtools read what the program of drawings writes.
# shellcheck source=/dev/null
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/harness.sh"
require hosts/drawing_tools product/models
ensure_drawing_tools || skip "$OBSTACLE"

write_cube
write_bumpy_torus 160 80 >torus.ply
for scale in 1:1 1:2; do
    for ending in svg dxf; do
        "$PROGRAM" "cube_$scale.$ending" --views front,left,top --strokes plain --furniture none --paper a2 \
            --scale $scale cube.off >/dev/null
    done
done
"$PROGRAM" torus.svg --views front,30,25 --strokes plain --furniture none --paper fit --scale 50:1 torus.ply >/dev/null
"$PROGRAM" cut.dxf --views front,top --section x=0.5 cube.off >/dev/null
dragon=$(dragon_file _res2) # a scan, once it is fetched
[[ ! -s $dragon ]] || "$PROGRAM" scan.svg --views six --strokes plain --furniture none --unit m "$dragon" >/dev/null
"$DRAWING_PYTHON" -B "$HERE/others.py" "$WORK"
echo passed
