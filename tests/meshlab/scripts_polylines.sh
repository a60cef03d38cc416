#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lines as polylines in scripts: the example, the files that MeshLab writes of them, and errors.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
EXAMPLE=$CHECKOUT/docs/examples/laplacian_lines_polylines.mlx

# accept FILE [KEY=VALUE...]
accept() {
    local file=$1
    shift
    write_script script.mlx "$@"
    rm -f "$WORK/$file"
    serve -i torus.ply -s script.mlx -o "$file"
    ((SERVER_CODE == 0)) || fail "the script with $* ended with $SERVER_CODE"
    [[ -s $WORK/$file ]] || fail "the script with $* wrote no $file"
}

# place NAME X Y Z: gives the example's point other coordinates from now on
place() {
    sed -E "s/(name=\"$1\" [^>]*) x=\"[^>]*\"\/>/\1 x=\"$2\" y=\"$3\" z=\"$4\"\/>/" "$EXAMPLE" >"$WORK/changed.mlx"
    EXAMPLE=$WORK/example.mlx
    mv "$WORK/changed.mlx" "$EXAMPLE"
}

# expect_silence: no warning of the view
expect_silence() {
    ! grep -q 'Warning: the viewpoint' "$WORK/log" || fail "it warns of the view: $(grep 'Warning: the' "$WORK/log")"
}

segments() {
    sed -n -E 's/.*Lines of torus.ply: .* ([0-9]+) segments; .*/\1/p' "$WORK/log" | tail -n 1
}

torus "$WORK/torus.ply"
accept lines.ply
expect_text "$WORK/log" 'torus\.ply has no precomputed attributes; computed with the default options'
expect_text "$WORK/log" '[1-9][0-9]* Laplacian lines, [1-9][0-9]* occluding contours, .*; orthographic, along the view direction 0 0 1 \(Front\)'
expect_silence
visible=$(segments)
# MeshLab writes no edges into PLY files, but the vertices
grep -aq '^element vertex [1-9]' "$WORK/lines.ply" || fail "lines.ply holds no vertices"
! grep -aq '^element face [1-9]' "$WORK/lines.ply" || fail "lines.ply holds faces"
accept lines.obj
[[ $(grep -c '^l ' "$WORK/lines.obj") == "$visible" ]] || fail "lines.obj does not hold $visible segments"
accept lines.dxf
[[ $(grep -cE '^ *LINE' "$WORK/lines.dxf") == "$visible" ]] || fail "lines.dxf does not hold $visible lines"

accept all.ply visible_only=false
(($(segments) > visible)) || fail "hidden lines are left out unasked"
accept contours.ply laplacian_lines=false ridges=false borders=false
expect_text "$WORK/log" 'Lines of torus.ply: [0-9]+ occluding contours, [0-9]+ segments'
# kinds by mixtures, whichever are switched on
accept mixture.ply settings=3 contours=false
expect_text "$WORK/log" 'Lines of torus.ply: [0-9]+ occluding contours, [0-9]+ suggestive contours, [0-9]+ segments'
accept mixture.ply settings=5
expect_text "$WORK/log" 'Lines of torus.ply: [0-9]+ occluding contours, [0-9]+ apparent ridges, [0-9]+ segments'
accept detailed.ply detail=90
(($(segments) > visible)) || fail "more detail gives no more lines"
accept lit.ply light=1
accept orthographic.ply view=2
expect_text "$WORK/log" 'orthographic, along the view direction 0 0 1'
sides=([4]='0 0 -1 \(Back\)' [5]='-1 0 0 \(Left\)' [6]='1 0 0 \(Right\)' [7]='0 1 0 \(Top\)' [8]='0 -1 0 \(Bottom\)')
for number in "${!sides[@]}"; do
    accept side.ply view="$number"
    expect_text "$WORK/log" "orthographic, along the view direction ${sides[number]}"
done
place viewpoint 5 1 1
accept other.ply view=1
expect_text "$WORK/log" 'perspective, from the viewpoint 5 1 1'
expect_silence
# in the hole of the torus, and too close to it
place viewpoint 0 0 0.1
accept within.ply view=1
expect_text "$WORK/log" 'Warning: the viewpoint 0 0 0\.1 is within the bounding box of the layer, which reaches from -1\..* to 1\..*: not all of it is in sight'
place viewpoint 0 0 0.6
accept close.ply view=1
expect_text "$WORK/log" 'Warning: the viewpoint 0 0 0\.6 is close to the box of the layer'

refuse_settings 'There is no window with a current view\. Set "View" to 3 \(Front\)' view=0
refuse_settings '"View" is 9\. It has to be one of 0 ' view=9
refuse_settings 'The decoration Laplacian Lines has drawn nothing here' settings=1
refuse_settings '"Settings" is 10\. It has to be one of 0 ' settings=10
refuse_settings '"Detail" is 101\. It has to be between 0 and 100' detail=101
refuse_settings 'No lines are seen from there, so no layer was created' laplacian_lines=false ridges=false borders=false contours=false
place viewpoint 1 0 0
refuse_settings 'The viewpoint is inside the surface' view=1
place viewpoint nan 0 0
refuse_settings '"Viewpoint" has to be three finite numbers'
place viewpoint 5 1 1
place light_direction 0 0 0
refuse_settings '"Light Direction" is 0 0 0, which is not a direction' light=1 view=2
