# SPDX-License-Identifier: GPL-3.0-or-later
# One script at a time changes a folder: ./run and ./test may be called at once in the same checkout.

require environment/messages

# take_turn FOLDER: returns when no other script has its turn there; until end_turn, none gets one. A turn also ends with
# the script that has it, when the last of its programs has ended. Short waits in a loop: a signal ends each of them.
take_turn() {
    local code=75
    { mkdir -p "$1" && : >>"$1/.lock"; } 2>/dev/null ||
        fail "$1 cannot be written into, and what is missing is built there: run this as its owner, or copy the checkout to a place of your own"
    exec {TURN}>>"$1/.lock"
    ! flock --nonblock "$TURN" || return 0
    say "another run is building in $1: waiting until it is done"
    while ((code == 75)); do
        code=0
        flock --timeout 1 --conflict-exit-code 75 "$TURN" || code=$? # others: a file system without locks
    done
}

end_turn() {
    exec {TURN}>&-
}
