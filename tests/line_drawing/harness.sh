# SPDX-License-Identifier: GPL-3.0-or-later
# What tests of the program of drawings share. A test sources this file; it is called with the program, and has
#   $PROGRAM   the program             $HERE    the folder of the tests
# The test begins in an empty folder, which goes with it.
set -euo pipefail

HERE=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=/dev/null
source "$HERE/../../scripts/require.sh" environment/messages

PROGRAM=$(readlink -f "$1")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
cd "$WORK"

# skip REASON: ends the test, as a failure where LAPLACIAN_LINES_REQUIRED is true
skip() {
    echo "skipped: $1"
    if [[ ${LAPLACIAN_LINES_REQUIRED:-} == true ]]; then exit 1; fi
    exit 77
}

# a cube of 100 mm of 12 triangles, in three formats
write_cube() {
    local v f
    v=$(printf '%s\n' "0 0 0" "100 0 0" "100 100 0" "0 100 0" "0 0 100" "100 0 100" "100 100 100" "0 100 100")
    f=$(printf '%s\n' "0 2 1" "0 3 2" "4 5 6" "4 6 7" "0 1 5" "0 5 4" "1 2 6" "1 6 5" "2 3 7" "2 7 6" "3 0 4" "3 4 7")
    { printf 'OFF\n8 12 0\n%s\n' "$v"; awk '{ print 3, $0 }' <<<"$f"; } >cube.off
    { awk '{ print "v", $0 }' <<<"$v"; awk '{ print "f", $1 + 1, $2 + 1, $3 + 1 }' <<<"$f"; } >cube.obj
    {
        printf 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n'
        printf 'element face 12\nproperty list uchar int vertex_indices\nend_header\n%s\n' "$v"
        awk '{ print 3, $0 }' <<<"$f"
    } >cube.ply
}
