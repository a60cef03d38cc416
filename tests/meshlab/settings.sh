#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run --set in a window: the lines follow, and the next window has the user's settings again.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
require product/settings product/window

torus "$WORK/torus.ply"
reds=("Line Color=red" "contour_color=#f00")

# kept_settings FILE: what MeshLab has kept of the decoration's parameters
kept_settings() {
    grep LaplacianLines "$HOME/.config/VCG/MeshLab_64bit_fp.conf" | sort >"$1"
    [[ -s $1 ]] || fail "MeshLab keeps no parameters of the decoration"
}

# in_window NAME COMMANDS SETTING...: with the window closed at the end, MeshLab has kept NAME
in_window() {
    write_settings "$LAPLACIAN_LINES_BUILD" "$WORK/settings" "${@:3}"
    printf '%s\n' "check Show Info Panel off" "check Show Trackball off" "check Laplacian Lines Probe on" "$2" leave \
        >>"$WORK/settings"
    open_window "$STAGE" "$WORK" "$WORK/torus.ply"
    kept_settings "$WORK/$1"
}

in_window before ""
in_window set "expect-lines detail=70 ridges=0" Detail=70 ridges=no "${reds[@]}"
in_window after "expect-lines" "${reds[@]}"
diff "$WORK/before" "$WORK/set" || fail "what was set for one window is kept"
diff "$WORK/before" "$WORK/after" || fail "what was set for one window is kept"

rm -f "$WORK/log"
! (write_settings "$LAPLACIAN_LINES_BUILD" "$WORK/settings" Detail=70 Detail=abc) 2>"$WORK/log" || fail "abc is taken"
expect_text "$WORK/log" '^laplacian-lines: "Detail" is abc. It has to be between 0 and 100.$'
! (write_settings "$LAPLACIAN_LINES_BUILD" "$WORK/settings" "Valley Angle=20") 2>"$WORK/log" || fail "what went is taken"
expect_text "$WORK/log" '"Valley Angle" can no longer be set, it is always that of ridges. Set Ridge Angle.$'
! (write_settings "$LAPLACIAN_LINES_BUILD" /dev/full Detail=70) 2>"$WORK/log" || fail "half of the settings were taken"
expect_text "$WORK/log" 'cannot be written: No space left on device'
