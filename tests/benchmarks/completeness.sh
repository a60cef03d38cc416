#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The table of how complete drawings are: of one mesh, in two styles, with its picture and its JSON.
#   completeness.sh PROGRAM
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$1" --only octahedron --set mesh_silhouettes=1 --pictures "$work/pictures" --json "$work/report.json" \
    >"$work/table"
cat "$work/table"
grep -qE '^octahedron +sharp +8 +[0-9]+[op] +1\.0000 +1\.0000 ' "$work/table" || fail "no line of an octahedron"
grep -qE '^all +1 +1 \(100 %\) +1\.000 ' "$work/table" || fail "no summary"
grep -q '^the worst: octahedron$' "$work/table" || fail "the worst are not named"
[[ $(stat -c %s "$work/pictures/octahedron.ppm") == $((15 + 3 * 400 * 400)) ]] || fail "no picture of 400 x 400"
grep -q '"name": "octahedron"' "$work/report.json" || fail "no JSON"

"$1" --only octahedron --set contours=0 --set ridges=0 --set creases=0 >"$work/empty"
! cmp -s "$work/table" "$work/empty" || fail "the style does not matter"

! "$1" --set no_such_key=1 2>"$work/log" || fail "an unknown option is taken"
grep -q 'KEY=VALUE with a key of the style, not no_such_key=1' "$work/log" || fail "no reason is given"
! "$1" --only missing missing.ply >"$work/none" 2>"$work/log" || fail "a missing file is no failure"
