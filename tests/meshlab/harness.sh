# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests in MeshLab share. A test sources this file and then has
#   $WORK            an empty folder of its own, kept afterwards for a look
#   drive            runs MeshLab with the driver script on stdin and expects success
#   drive_to_failure the same, but expects MeshLab to end with an error whose text matches $1
#   show_lines       prints the commands that draw a view's lines in red
#   save_attributes BINARY  prints the commands that save the current layer with the filter's attributes
#   drive_lines MESH drive, with MESH open and its lines drawn in red before the script on stdin begins
#   move_layer SETTING...  prints the commands that give the current layer a transformation
#   serve ARGS...    runs meshlabserver ARGS..., its exit code in $SERVER_CODE, its output in $WORK/log
#   write_script FILE [KEY=VALUE...]  a script for it, the example with other values
#   refuse_settings REASON [KEY=VALUE...]  meshlabserver refuses the example with other values, for this reason
#   expect_text FILE REGEX        expect_picture FILE WxH       expect_same_picture FILE FILE PIXELS
#   red_pixels FILE               how much of the lines' red a picture has
#   small_torus FILE              a mesh
#   torus FILE                    one with lines all over it
#   sphere FILE                   one with nothing but a contour
#   reference_mesh NAME           $WORK/NAME.ply, a mesh of the core's tests, and what the core computes on it
#   expect_reference_attributes FILE      a binary PLY file has these attributes
#   write_mesh FILE COMMAND...    what the command prints
#   box FILE SIZE                 a cube
#   ply FILE VERTICES FACES       an ASCII file with the vertices and faces on stdin
#   expect_file FILE              it is there, with something in it
#   expect_ink A B FACTOR         picture B has at least FACTOR times as much of the lines' red as A
#   times N LINE...               prints the lines N times
#   from_version YEAR LINE OTHER  prints LINE in a MeshLab of that year or later, else OTHER
# With set -e, the first thing that is not as expected ends the test and shows the logs.
set -euo pipefail

TEST_NAME=${TEST_NAME:-$(basename "$0" .sh)}
CHECKOUT=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
EXAMPLE=$CHECKOUT/docs/examples/laplacian_lines.mlx
STAGE=$LAPLACIAN_LINES_BUILD/stage
WORK=$LAPLACIAN_LINES_BUILD/Testing/meshlab/$TEST_NAME
DISPLAY_SIZE=${DISPLAY_SIZE:-1700x1000}
DRIVE_SECONDS=${DRIVE_SECONDS:-200} # a hung MeshLab, before ctest's own limit, so that its log is shown

# shellcheck source=/dev/null
source "$CHECKOUT/scripts/require.sh" environment/cache environment/messages environment/packages product/display product/models \
    product/private_home product/stage

end_test() {
    local code=$?
    stop_display
    if ((code != 0 && code != 77)) && [[ -s $WORK/log ]]; then
        printf -- '--- the end of %s\n' "$WORK/log"
        tail -n 60 "$WORK/log"
    fi
    exit "$code"
}

begin_test() {
    rm -rf "$WORK"
    mkdir -p "$WORK"
    trap end_test EXIT
    trap 'exit 143' TERM INT
    start_display "${DISPLAY_SIZE%x*}" "${DISPLAY_SIZE#*x}"
    LAPLACIAN_LINES_CACHE=$(cache_folder) # the user's: models are fetched once
    export LAPLACIAN_LINES_CACHE
    use_private_home "$WORK/home"
    white_background "$WORK/home"
    # The same pixels on every machine, whatever the graphics card
    export LIBGL_ALWAYS_SOFTWARE=1
    export LAPLACIAN_LINES_PROBE=1 # the decoration that expect-lines needs
}

# run_driver: the exit code of MeshLab driven by the script on stdin
run_driver() {
    cat >"$WORK/script"
    printf 'quit\n' >>"$WORK/script"
    local code=0
    (cd "$WORK" && LAPLACIAN_LINES_DRIVER=$WORK/script timeout --kill-after=5 "$DRIVE_SECONDS" \
        "$STAGE/bin/meshlab" >"$WORK/log" 2>&1) || code=$?
    return "$code"
}

drive() {
    local code=0
    run_driver || code=$?
    ((code == 0)) || fail "MeshLab ended with $code: $(grep 'meshlab_driver: error' "$WORK/log" || echo 'no word from the driver')"
}

drive_to_failure() {
    local code=0
    run_driver || code=$?
    ((code == 3)) || fail "MeshLab ended with $code instead of the driver's 3"
    expect_text "$WORK/log" "meshlab_driver: error: .*$1"
}

# Nothing but meshes and the current layer's lines in the view, and the probe that expect-lines needs
show_lines() {
    cat <<'END'
check Show Info Panel off
check Show Trackball off
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Line Color = #ff0000
setdeco Contour Color = #ff0000
END
}

# BINARY is on or off
save_attributes() {
    cat <<END
trigger Export Mesh...
set-modal Binary encoding = $1
END
    "$WRITE_REFERENCE" --attributes | sed -E 's/(.*):1$/set-modal V(f): \1 = on/; s/(.*):3$/set-modal V(3f): \1 = on/'
    printf 'button OK\n'
}

drive_lines() {
    drive < <(printf 'wait\nopen %s\nsize 800x600\n' "$1" && show_lines && cat)
}

# move_layer SETTING...: fields of MeshLab's filter, as "X Scale = 2"; the coordinates stay as they are
move_layer() {
    printf 'trigger Matrix: Set from translation/rotation/scale\nset Freeze Matrix = off\n'
    printf 'set %s\n' "$@"
    printf 'apply\nclose\n'
}

serve() {
    if [[ ! -x $STAGE/bin/meshlabserver ]]; then
        say "skipped: MeshLab $(meshlab_version) has no meshlabserver"
        exit 77
    fi
    SERVER_CODE=0
    (cd "$WORK" && timeout --kill-after=5 "$DRIVE_SECONDS" "$STAGE/bin/meshlabserver" "$@" >"$WORK/log" 2>&1) || SERVER_CODE=$?
}

# write_script FILE [KEY=VALUE...]: the example with other values
write_script() {
    local file=$WORK/$1 setting edits=()
    shift
    for setting in "$@"; do
        grep -q "name=\"${setting%%=*}\"" "$EXAMPLE" || fail "the example has no parameter ${setting%%=*}"
        edits+=(-e "s/\(name=\"${setting%%=*}\" [^>]* value=\"\)[^\"]*/\1${setting#*=}/")
    done
    sed "${edits[@]}" -e '' "$EXAMPLE" >"$file"
}

# refuse_settings REASON [KEY=VALUE...]: for torus.ply; no file is left behind, which would hold the mesh without result
refuse_settings() {
    local reason=$1
    shift
    write_script script.mlx "$@"
    rm -f "$WORK/none.ply"
    serve -i torus.ply -s script.mlx -o none.ply
    ((SERVER_CODE != 0)) || fail "the script with $* was accepted"
    expect_text "$WORK/log" "$reason"
    [[ ! -e $WORK/none.ply ]] || fail "the script with $* wrote a mesh"
}

expect_text() {
    grep -Eq -- "$2" "$1" || fail "$1 has nothing that matches: $2"
}

expect_picture() {
    local size
    size=$(identify -format '%wx%h' "$1") || fail "$1 is not a picture"
    [[ $size == "$2" ]] || fail "$1 is $size instead of $2"
}

# expect_same_picture A B PIXELS: at most PIXELS differ
expect_same_picture() {
    local differing
    differing=$(differing_pixels "$1" "$2") || fail "$1 and $2 cannot be compared"
    ((differing <= $3)) || fail "$differing pixels differ between $1 and $2, more than $3"
}

# differing_pixels A B: how many there are
differing_pixels() {
    convert "$1" "$2" -alpha off -compose Difference -composite -fill white +opaque black -colorspace gray \
        -format '%[fx:round(mean*w*h)]' info:
}

# red_pixels FILE: how many there are
red_pixels() {
    convert "$1" -alpha off -fuzz 35% -fill black +opaque red -fill white -opaque red -colorspace gray \
        -format '%[fx:round(mean*w*h)]' info:
}

# 2,400 triangles
small_torus() {
    write_bumpy_torus 40 30 >"$1"
}

# 25,600 triangles
torus() {
    write_bumpy_torus 160 80 >"$1"
}

write_mesh() {
    "${@:2}" >"$1"
}

box() {
    awk -v half="$(($2 / 2))" 'BEGIN {
        print "OFF\n8 6 0"
        for (i = 0; i < 8; ++i) print (i % 2 * 2 - 1) * half, (int(i / 2) % 2 * 2 - 1) * half, (int(i / 4) * 2 - 1) * half
        print "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5"
    }' >"$1"
}

ply() {
    printf 'ply\nformat ascii 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' "$2" >"$1"
    printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' "$3" >>"$1"
    grep . >>"$1"
}

times() {
    local i
    for ((i = 0; i < $1; ++i)); do printf '%s\n' "${@:2}"; done
}

from_version() {
    if [[ $(meshlab_version) > $1 ]]; then printf '%s\n' "$2"; else printf '%s\n' "$3"; fi
}

expect_ink() {
    local a b
    a=$(red_pixels "$1")
    b=$(red_pixels "$2")
    awk "BEGIN { exit !($a > 0 && $b >= $3 * $a) }" || fail "$2 has $b red pixels, $1 has $a"
}

expect_file() {
    [[ -s $1 ]] || fail "$1 was not written"
}

# of radius 1, 180 by 90 facets
sphere() {
    awk 'BEGIN {
        n = 180; m = 90; pi = atan2(0, -1)
        printf "ply\nformat ascii 1.0\nelement vertex %d\n", n * (m - 1) + 2
        print "property float x\nproperty float y\nproperty float z"
        printf "element face %d\nproperty list uchar int vertex_indices\nend_header\n", 2 * n * (m - 1)
        print "0 0 1"
        for (j = 1; j < m; j++) for (i = 0; i < n; i++)
            print sin(pi * j / m) * cos(2 * pi * i / n), sin(pi * j / m) * sin(2 * pi * i / n), cos(pi * j / m)
        print "0 0 -1"
        for (i = 0; i < n; i++) print 3, 0, 1 + i, 1 + (i + 1) % n
        for (j = 0; j < m - 2; j++) for (i = 0; i < n; i++) {
            a = 1 + j * n + i; b = 1 + j * n + (i + 1) % n
            print 3, a, a + n, b
            print 3, b, a + n, b + n
        }
        last = n * (m - 1) + 1
        for (i = 0; i < n; i++) print 3, last, last - n + (i + 1) % n, last - n + i
    }' >"$1"
}

reference_mesh() {
    "$WRITE_REFERENCE" "$1" "$WORK" || fail "there is no mesh $1"
    REFERENCE=$WORK/$1.txt
}

# Not a bit differs: the plugin and the reference are made of the same core, and files hold floats.
expect_reference_attributes() {
    "$COMPARE_ATTRIBUTES" "$1" "$REFERENCE" 0 || fail "$1 has other attributes than the core computes"
}

begin_test
