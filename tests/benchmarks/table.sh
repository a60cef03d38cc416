#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./bench's table and its JSON, of a small mesh. The program fails by itself when the extractor and the plain loops
# find zeros of different length.
#   table.sh PROGRAM, with the build in $LAPLACIAN_LINES_BUILD
set -euo pipefail

here=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")
# shellcheck source=/dev/null
source "$here/../../scripts/require.sh" environment/messages measures/core_times product/models
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# expect_line REGEX
expect_line() {
    grep -qE "^$1$" "$work/table" || fail "the table lacks: $1"
}

write_bumpy_torus 60 30 >"$work/torus.ply"
"$here/../../bench" --quick --json "$work/report.json" "$work/torus.ply" >"$work/table" || fail "./bench fails"
cat "$work/table"
expect_line 'Commit .*'
expect_line '\| triangles \| 3,600 \|'
expect_line '\| plain contours, not traced \| [0-9.]+ \|'
cmake -D REPORT="$work/report.json" -P "$here/check_report.cmake"

"$1" --rounds 1 --subdivide 1 "$work/torus.ply" >"$work/table"
expect_line '\| triangles \| 3,600 \| 14,400 \|'
expect_line '\| plain contours \| – \| [-0-9.]+ \|'

! "$1" --rounds 0 "$work/torus.ply" 2>"$work/log" || fail "--rounds 0 is taken"
grep -q -- '--rounds needs a number, at least 1' "$work/log" || fail "no reason is given"

printf '{"filter_s": 1}\n' >"$work/in_meshlab"
printf '{"machine": {"processors": 2}}\n' >"$work/core"
join_figures 0123abcd "$work/core" "$work/in_meshlab" >"$work/report.json"
cmake -D REPORT="$work/report.json" -D IN_MESHLAB=ON -P "$here/check_report.cmake"
