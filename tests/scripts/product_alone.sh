#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./run takes has no need of the tests: in a copy of the checkout without them, the command and CMake know all that
# they look for, and nothing there names them.
#   product_alone.sh FOLDER_OF_MESHLAB_SOURCES
set -euo pipefail

checkout=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What only ./test and ./bench read
others=(tests benchmarks scripts/checks scripts/hosts scripts/measures test bench)

for name in "$checkout"/*; do
    [[ $name == */build* ]] || cp -R "$name" "$work"
done
(cd "$work" && rm -r "${others[@]}")

"$work/run" --help >"$work/help"
cmake -S "$work" -B "$work/build" -DMESHLAB_SOURCE_DIR="${1:-}" -DLAPLACIAN_LINES_BUILD_DRIVER=ON >"$work/log" 2>&1 || {
    tail -n 20 "$work/log"
    exit 1
}
! grep -rnE 'tests/|test_meshes|core_test_helpers' "$work" --exclude-dir=build --exclude-dir=docs --exclude='*.md' |
    grep -vE ':[0-9]+: *(//|# )' # comments may
