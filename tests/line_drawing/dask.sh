#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# dask.sh PROGRAM: the example of drawings by several machines, with two workers on this one.
# shellcheck source=/dev/null
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/harness.sh"
require hosts/drawing_tools

# -S: as where no packages are installed
! python3 -S -B "$HERE/../../docs/examples/draw_with_dask.py" plates one.ply 2>said || fail "Dask is not needed"
grep -q "Install it: .*-m pip install dask distributed" said || fail "it is not said what to install: $(cat said)"

ensure_drawing_tools || skip "$OBSTACLE"
write_cube
for name in one two three; do cp cube.ply $name.ply; done
echo "no mesh" >bad.ply
draw=("$DRAWING_PYTHON" -B "$HERE/../../docs/examples/draw_with_dask.py" --program "$PROGRAM" plates)

"${draw[@]}" one.ply two.ply three.ply -- --views front,left >said
cat said
for name in one two three; do
    [[ -s plates/$name.pdf ]] || fail "$name has no drawing"
    grep -qx "plates/$name.pdf: drawn" said || fail "a worker did not draw $name"
done
grep -qx "0 drawn, 3 unchanged, 0 not drawn" said || fail "drawings of workers were made again"
[[ -s plates/contact_sheet.pdf ]] || fail "there is no contact sheet"

! "${draw[@]}" bad.ply one.ply -- --views left >said || fail "a mesh that cannot be drawn is not an error"
grep -q "^bad.ply: not drawn: " said || fail "the bad mesh is not reported: $(cat said)"
grep -qx "plates/one.pdf: drawn" said || fail "a bad mesh keeps others from being drawn"
echo passed
