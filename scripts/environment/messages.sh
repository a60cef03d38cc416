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

# end_at_signals COMMAND: from now on a signal ends the script at once, also while quietly() runs a command, which then
# ends with all that it has begun; COMMAND tidies up, whenever the script ends.
end_at_signals() {
    declare -g COMMAND_GROUP=
    # shellcheck disable=SC2064
    trap "stop_group; $1" EXIT
    trap 'exit 130' INT
    trap 'exit 143' TERM
}

stop_group() {
    [[ -z $COMMAND_GROUP ]] || kill -TERM -- "-$COMMAND_GROUP" 2>/dev/null || true
}

# in_own_group COMMAND...: bash obeys a signal when what is in front has ended, but not what it waits for
in_own_group() {
    local code=0
    set -m
    "$@" &
    COMMAND_GROUP=$!
    set +m
    wait "$COMMAND_GROUP" || code=$?
    COMMAND_GROUP=
    return "$code"
}

# quietly LOG COMMAND...: the output goes to LOG, its end to the user when the command fails.
quietly() {
    local log=$1 launcher=()
    shift
    mkdir -p "$(dirname "$log")"
    [[ ! -v COMMAND_GROUP ]] || launcher=(in_own_group)
    "${launcher[@]}" "$@" >"$log" 2>&1 && return 0
    tail -n 40 "$log" >&2
    return 1
}
