#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Options of ./run that are refused at once, before anything is built; those of pictures are in picture_options.sh.
set -euo pipefail

checkout=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
# shellcheck source=/dev/null
source "$checkout/scripts/require.sh" environment/messages
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# refuses REASON OPTIONS...
refuses() {
    ! LAPLACIAN_LINES_BUILD=$work/build "$checkout/run" "${@:2}" 2>"$work/log" || fail "taken: ${*:2}"
    grep -qE "^laplacian-lines: $1" "$work/log" || fail "${*:2}: $(<"$work/log")"
    [[ ! -e $work/build ]] || fail "built in spite of ${*:2}"
}

refuses '--set needs NAME=VALUE' --set
refuses '--set needs NAME=VALUE' --set Detail
refuses '--set goes with a window or a picture, not with --install' --set Detail=70 --install
refuses '--set goes with a window or a picture, not with --python' --set Detail=70 --python -c pass
refuses 'unknown option --sets' --sets Detail=70
refuses 'there is no mesh ' "$work/none.ply"
