# SPDX-License-Identifier: GPL-3.0-or-later
# The same command for several values at once.

# in_parallel COMMAND ARGS -- VALUES...: COMMAND ARGS VALUE for all values at once; fails if one does
in_parallel() {
    local command=() jobs=() job failed=0
    while [[ $1 != -- ]]; do
        command+=("$1")
        shift
    done
    shift
    for job in "$@"; do
        "${command[@]}" "$job" &
        jobs+=($!)
    done
    for job in "${jobs[@]}"; do
        wait "$job" || failed=1
    done
    return "$failed"
}
