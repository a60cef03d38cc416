# SPDX-License-Identifier: GPL-3.0-or-later
# A virtual X display of our own, as large as asked, ended by its process id.

require environment/messages

# start_display WIDTH HEIGHT: sets DISPLAY and DISPLAY_PID.
start_display() {
    local number fifo
    fifo=$(mktemp -u)
    mkfifo -m 600 "$fifo"
    # Xvfb picks a free display itself and tells it through the file descriptor, once it accepts clients.
    Xvfb -displayfd 9 -screen 0 "$1x$2x24" +extension GLX -nolisten tcp -noreset 9>"$fifo" >/dev/null 2>&1 &
    DISPLAY_PID=$!
    read -r -t 60 number <"$fifo" || number=
    rm -f "$fifo"
    if [[ -z $number ]]; then
        stop_display
        fail "the virtual display Xvfb did not start"
    fi
    export DISPLAY=:$number
    unset XAUTHORITY WAYLAND_DISPLAY
    export QT_QPA_PLATFORM=xcb
}

stop_display() {
    [[ -n ${DISPLAY_PID:-} ]] || return 0
    kill "$DISPLAY_PID" 2>/dev/null || true
    wait "$DISPLAY_PID" 2>/dev/null || true
    DISPLAY_PID=
}
