#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A checkout that was copied or moved together with its build is built anew, of its own sources; other builds in the same
# folder are left alone.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/build environment/messages
unset LAPLACIAN_LINES_BUILD MESHLAB_SOURCE_DIR
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# write_place FOLDER: what the program there says
write_place() {
    printf '#include <cstdio>\nint main() { std::puts("%s"); }\n' "$1" >"$work/$1/main.cpp"
}

# expect_build FOLDER REGEX: builds the program, which says FOLDER; the script says REGEX, nothing if that is empty
expect_build() {
    (build_targets "$work/$1" program) 2>"$work/log" || fail "$1 cannot be built: $(<"$work/log")"
    [[ $("$work/$1/build/program") == "$1" ]] || fail "the program in $1 is of other sources"
    if [[ -n $2 ]]; then
        grep -q "$2" "$work/log" || fail "$1: nothing says: $2"
    else
        [[ ! -s $work/log ]] || fail "$1: $(<"$work/log")"
    fi
}

mkdir "$work/first"
printf '%s\n' 'cmake_minimum_required(VERSION 3.18)' 'project(moved LANGUAGES CXX)' 'add_executable(program main.cpp)' \
    >"$work/first/CMakeLists.txt"
write_place first
expect_build first ''
mkdir -p "$work/first/build/other/CMakeFiles"
touch "$work/first/build/other/CMakeCache.txt"

cp -a "$work/first" "$work/second"
write_place second
touch -d '2001-01-01' "$work/second/main.cpp" # older than what was compiled of the first one
expect_build second 'building anew'
expect_build second ''
[[ -d $work/second/build/other/CMakeFiles ]] || fail "another build was touched"

rm "$work/first/main.cpp"
mv "$work/second" "$work/third"
write_place third
expect_build third 'building anew'
