# SPDX-License-Identifier: GPL-3.0-or-later
# Files that are there whole or not at all.

require environment/messages

# put_file FILE TARGET: a copy of FILE as TARGET, or as what TARGET links to. What was there is whole until it is replaced,
# and stays if there is no room; into devices and pipes is written.
put_file() {
    local place beside
    place=$(readlink -f "$2") || fail "cannot write $2: there is no such folder"
    [[ ! -d $place ]] || fail "cannot write $2: it is a folder"
    if [[ -e $place && ! -f $place ]]; then
        cat "$1" >"$place" || fail "cannot write into $2"
        return
    fi
    beside=$(mktemp "$(dirname "$place")/.laplacian_lines_XXXXXX") || fail "cannot write into the folder of $2"
    if ! { cat "$1" >"$beside" && sync "$beside" && chmod "$(printf '%o' $((0666 & ~$(umask))))" "$beside" &&
        mv -T "$beside" "$place"; }; then
        rm -f "$beside"
        fail "cannot write $2; what was there is unchanged"
    fi
}
