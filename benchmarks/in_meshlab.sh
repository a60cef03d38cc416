#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the plugins cost inside MeshLab, in a view of 1000 x 700 without a display, as JSON:
#   benchmarks/in_meshlab.sh [MESH], the Stanford dragon if none is named
#   filter       Compute Laplacian Lines with its defaults, in all, as MeshLab's log has it
#   switch_on    Laplacian Lines switched on after it: the lines made ready, and the plugin's part of the first redraw
#   extract, upload, draw_calls   the plugin's part of a redraw, medians of all directions around the mesh: finding the
#                lines, handing them to OpenGL, and telling it what to draw, with all that remains
#   drawing      OpenGL's part, here by software: the call that draws, which shades the points before it returns, and
#                waiting for the end
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=/dev/null
source "$root/scripts/require.sh" environment/build environment/messages environment/packages \
    product/display product/models product/picture product/private_home product/stage
build=$(build_folder "$root")
redraws=48

work=$(mktemp -d)
trap 'stop_display; rm -rf "$work"' EXIT
trap 'exit 143' TERM INT

measure() {
    start_display 1700 1000
    use_private_home "$work/home"
    export LIBGL_ALWAYS_SOFTWARE=1 LAPLACIAN_LINES_PROBE=1
    cat >"$work/script" <<END
time-limit 600
wait
open $MESH
size 1000x700
trigger Compute Laplacian Lines
apply
close
log $work/messages
check Laplacian Lines on
check Laplacian Lines Probe on
setdeco Show Statistics = on
turn $redraws 15 $work/redraws
quit
END
    run_meshlab "$build/stage" "$work" || {
        explain_failure "$work"
        fail "MeshLab ended with an error"
    }
}

# median PATTERN: of the numbers before its end, "ms" or "s", in the boxes of all redraws
median() {
    sed -n "s/.*$1 \([0-9.]*\) m\{0,1\}s.*/\1/p" "$work/redraws" | sort -n |
        awk '{ value[NR] = $1 } END { if (!NR) exit 1; print value[int((NR + 1) / 2)] }' ||
        fail "MeshLab's view does not show: $1"
}

filter_seconds() {
    sed -n 's/.*Applied filter Compute Laplacian Lines in \([0-9]*\) msec.*/\1/p' "$work/messages" |
        awk '{ print $1 / 1000; found = 1 } END { exit !found }' || fail "MeshLab's log does not tell the filter's time"
}

ensure_packages "${DISPLAY_PACKAGES[@]}"
ensure_toolchain
build_targets "$root" meshlab_plugins -- -DLAPLACIAN_LINES_BUILD_DRIVER=ON
stage_meshlab "$build/stage" "$build"/plugins/*.so "$build"/driver/*.so
prepare_mesh "${1:-}" "$work"
measure

filter=$(filter_seconds)
switch_on=$(median "switched on in")
extraction=$(median extraction)
upload=$(median upload)
draw_calls=$(median "draw calls")
drawing=$(median "drawing by OpenGL")
printf '{"filter_s": %s, "switch_on_s": %s, "extract_ms": %s, "upload_ms": %s, "draw_calls_ms": %s, "drawing_ms": %s}\n' \
    "$filter" "$switch_on" "$extraction" "$upload" "$draw_calls" "$drawing"
