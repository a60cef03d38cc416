#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CMake and make are asked again after any change that they would look at, and only then.
set -euo pipefail

# shellcheck source=/dev/null
source "$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh" environment/build environment/messages
unset LAPLACIAN_LINES_BUILD MESHLAB_SOURCE_DIR
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
made=$work/build/plugins/program

# expect_asked WHEN yes|no [OPTION]: whether building asks them
expect_asked() {
    local asked=no
    rm -f "$work/build/configure.log"
    build_targets "$work" program -- "${@:3}"
    [[ ! -e $work/build/configure.log ]] || asked=yes
    [[ $asked == "$2" ]] || fail "$1: asked: $asked"
    [[ -x $made ]] || fail "$1: nothing was built"
    sleep 0.02 # more than the steps of a file system's clock
}

mkdir "$work/sources"
# shellcheck disable=SC2016
printf '%s\n' 'cmake_minimum_required(VERSION 3.18)' 'project(unchanged LANGUAGES CXX)' \
    'set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)' 'file(GLOB files sources/*.cpp)' \
    'add_executable(program ${files})' >"$work/CMakeLists.txt"
echo 'int main() {}' >"$work/sources/main.cpp"
expect_asked 'at first' yes
expect_asked 'nothing has changed' no
touch "$work/sources/main.cpp"
expect_asked 'a source was changed' yes
expect_asked 'nothing has changed' no
echo 'int more;' >"$work/sources/more.cpp"
expect_asked 'a source is new' yes
rm "$work/sources/more.cpp"
expect_asked 'a source was removed' yes
touch "$work/CMakeLists.txt"
expect_asked 'the project was changed' yes
expect_asked 'nothing has changed' no
expect_asked 'another option' yes -DANYTHING=ON
expect_asked 'the same option' no -DANYTHING=ON
cmake -S "$work" -B "$work/build" -DCMAKE_BUILD_TYPE=Debug >/dev/null
expect_asked 'configured by hand' yes -DANYTHING=ON
rm "$made"
expect_asked 'what was made is gone' yes -DANYTHING=ON
echo wrong >"$work/sources/main.cpp"
! (build_targets "$work" program -- -DANYTHING=ON) 2>/dev/null || fail 'what is wrong was built'
! (build_targets "$work" program -- -DANYTHING=ON) 2>/dev/null || fail 'a build that had failed counts'
