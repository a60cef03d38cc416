# SPDX-License-Identifier: GPL-3.0-or-later
# Files that are there whole or not at all.

require environment/messages

# put_file FILE TARGET [MODE]: a copy of FILE as TARGET, or as what TARGET links to, with the usual rights or those of MODE.
# What was there is whole until it is replaced, and stays if there is no room; into devices and pipes is written.
put_file() {
    local mode=${3:-$(printf '%o' $((0666 & ~$(umask))))} place beside reason
    place=$(readlink -f "$2") || fail "cannot write $2: there is no such folder"
    [[ ! -d $place ]] || fail "cannot write $2: it is a folder"
    if [[ -e $place && ! -f $place ]]; then
        cat "$1" >"$place" || fail "cannot write into $2"
        return
    fi
    beside=$(mktemp "$(dirname "$place")/.laplacian_lines_XXXXXX") || fail "cannot write into the folder of $2"
    if ! reason=$(put_beside "$1" "$beside" "$mode" "$place" 2>&1); then
        rm -f "$beside"
        fail "cannot write $2: ${reason##*: }; what was there is unchanged"
    fi
}

# put_beside FILE BESIDE MODE TARGET
put_beside() {
    trap '' XFSZ # where a quota ends, writing says so
    cat "$1" >"$2" && sync "$2" && chmod "$3" "$2" && mv -T "$2" "$4"
}
