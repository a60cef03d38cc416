#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./bench's table and its JSON, of a small mesh. The program fails by itself when the extractor and the plain loops
# find zeros of different length.
#   table.sh PROGRAM
set -euo pipefail

here=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")
# shellcheck source=/dev/null
source "$here/../../setup/all.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

write_bumpy_torus 60 30 >"$work/torus.ply"
measure_core "$1" 0123abcd "$work/core" --precompute --rounds 2 --subdivide 1 "$work/torus.ply" >"$work/table"
printf '{"filter_s": 1}\n' >"$work/in_meshlab"
join_figures 0123abcd "$work/core" "$work/in_meshlab" >"$work/report.json"
cat "$work/table"
grep -q '^| triangles | 3,600 | 14,400 |$' "$work/table" || fail "the table lacks a column"
grep -qE '^\| suggestive contours, not traced \| [0-9.]+ \| [0-9.]+ \|$' "$work/table" || fail "the table lacks a row"
cmake -D REPORT="$work/report.json" -P "$here/check_report.cmake"

! "$1" --rounds 0 "$work/torus.ply" 2>"$work/log" || fail "--rounds 0 is taken"
grep -q -- '--rounds needs a number, at least 1' "$work/log" || fail "no reason is given"
"$here/../../bench" --help >/dev/null
