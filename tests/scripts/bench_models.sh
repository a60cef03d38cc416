#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The meshes of ./bench: those that lie beside the repository and the dragon; without either, one of our own making.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/messages measures/core_times
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LAPLACIAN_LINES_CACHE=$work/cache
npm() { return 1; } # no network
mkdir "$work/checkout"

# expect_models NAMES...: of the files
expect_models() {
    table_models "$work/checkout" bunny igea dragon_res2 2>"$work/log"
    [[ ${MODELS[*]##*/} == "$*" ]] || fail "the models are ${MODELS[*]}, not $*"
}

expect_models bumpy_torus.ply
grep -q 'left out: the model dragon_res2 cannot be fetched' "$work/log" || fail "nothing says what is left out"
[[ $(sed -n 's/^element face //p' "${MODELS[0]}") == 102400 ]] || fail "the torus is another one"

mkdir -p "$work/cache/models/dragon" "$work/shared/models"
echo ply >"$work/cache/models/dragon/dragon_res2.ply"
expect_models dragon_res2.ply
touch "$work/shared/models/igea.ply.gz"
expect_models igea.ply.gz dragon_res2.ply
