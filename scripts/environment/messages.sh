# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts tell the user: one line a step, on stderr so that stdout stays the program's own. The output of
# other programs is kept in logs.

say() {
    printf 'laplacian-lines: %s\n' "$*" >&2
}

fail() {
    say "$*"
    exit 1
}

# quietly LOG COMMAND...: the output goes to LOG, its end to the user when the command fails.
quietly() {
    local log=$1
    shift
    mkdir -p "$(dirname "$log")"
    "$@" >"$log" 2>&1 && return 0
    tail -n 40 "$log" >&2
    return 1
}
