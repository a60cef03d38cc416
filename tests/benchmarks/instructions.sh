#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./bench --instructions prints of a small mesh.
#   instructions.sh PROGRAM
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages measures/core_times product/models
command -v valgrind >/dev/null || {
    say "skipped: valgrind is not installed"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

write_bumpy_torus 60 30 >"$work/torus.ply"
count_instructions "$1" "$work/torus.ply" >"$work/table"
cat "$work/table"
for row in 'Laplacian lines and contours, [^|]*' 'plain contours, not traced' \
    'plain Laplacian lines, traced by a hash map'; do
    grep -qE "^\| $row \| [0-9.]+ \| [1-9][0-9]* \| [1-9][0-9]* \|$" "$work/table" || fail "no instructions of: $row"
done
