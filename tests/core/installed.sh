#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installed.sh EIGEN_INCLUDE_FOLDER: the core as "cmake --install" installs it. Each public header compiles alone and
# names Eigen and the standard library only; the example is built against the package and finds the lines of a torus.
set -euo pipefail

checkout=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
# shellcheck source=/dev/null
source "$checkout/scripts/require.sh" environment/messages
eigen=$1
work=$LAPLACIAN_LINES_BUILD/Testing/installed
prefix=$work/prefix

# compile_alone HEADER: as a program sees it that includes nothing before
compile_alone() {
    printf '#include <laplacian_lines/%s>\n' "$1" |
        "$CXX" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -I "$prefix/include" -isystem "$eigen" -x c++ - ||
        fail "$1 does not compile alone"
}

rm -rf "$work"
mkdir -p "$work"
cmake --install "$LAPLACIAN_LINES_BUILD" --component core --prefix "$prefix" >"$work/log"
find "$prefix" -type f | grep -vE '/include/laplacian_lines/[a-z_]+\.h$|/cmake/LaplacianLines/LaplacianLines[A-Za-z-]+\.cmake$|/liblaplacian_lines\.a$' &&
    fail "that is not a part of the core"

mapfile -t headers < <(ls "$prefix/include/laplacian_lines")
((${#headers[@]} > 10)) || fail "only ${#headers[@]} public headers"
(cd "$prefix/include" && grep -hoE '^ *#include.*' laplacian_lines/*.h | sort -u |
    grep -vE '^#include (<[a-z_]+>|<Eigen/[A-Za-z]+>|"laplacian_lines/[a-z_]+\.h")$') &&
    fail "public headers name other headers than Eigen's and the standard library's"
export -f compile_alone fail say
export prefix eigen
printf '%s\n' "${headers[@]}" | xargs -P "$(nproc)" -I{} bash -c 'compile_alone {}' || fail "not all headers compile"

cmake -S "$checkout/docs/examples/lines" -B "$work/example" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_PREFIX_PATH="$prefix" \
    >>"$work/log" || fail "the package is not found"
cmake --build "$work/example" >>"$work/log" || fail "the example cannot be built"

"$WRITE_REFERENCE" torus "$work"
awk '/^end_header/ { inside = 1; next }
    inside && NF == 3 { print "v", $0 }
    inside && NF == 4 { print "f", $2 + 1, $3 + 1, $4 + 1 }' "$work/torus.ply" >"$work/torus.obj"
"$work/example/lines" "$work/torus.obj" "$work/lines.obj"
# along its axis, a torus of the radii 1 and 0.4 has two outlines, circles of the radii 1.4 and 0.6
awk '$1 == "v" && NF == 4 { r = sqrt($2 * $2 + $3 * $3); ++vertices; outer += r > 1.38 && r < 1.42; inner += r > 0.58 && r < 0.62 }
    $1 == "l" { ++lines; for (i = 2; i <= NF; ++i) { ++used; wrong += $i < 1 || $i > vertices } }
    END {
        print vertices " vertices in " lines " lines, " outer " and " inner " on the outlines"
        exit !(lines >= 2 && used == vertices && outer > 40 && inner > 40 && wrong == 0)
    }' "$work/lines.obj" || fail "these are not the lines of a torus"

"$work/example/lines" "$work/none.obj" "$work/none_lines.obj" 2>"$work/log" && fail "a file that is not there has lines"
grep -q '^lines: The mesh has no triangle' "$work/log" || fail "the example does not say what is wrong"
