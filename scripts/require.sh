# SPDX-License-Identifier: GPL-3.0-or-later
# The parts that scripts are made of, each a file here with one subject. A script begins with
#   source .../scripts/require.sh PART...       as environment/cache
# and a part with the same without "source": each is read once, however many ask for it. Never source it without a
# PART: bash would hand on the script's own arguments.
# Parts are read inside a function: what they declare has to be global (declare -g).

# What scripts match and sort is the same everywhere (in Turkish, [A-Z] has no I); all else stays the user's.
sort_as_c() {
    local category
    if [[ -n ${LC_ALL:-} ]]; then
        for category in LC_CTYPE LC_NUMERIC LC_TIME LC_MONETARY LC_MESSAGES; do
            export "$category=$LC_ALL"
        done
        unset LC_ALL
    fi
    export LC_COLLATE=C
}

# Its numbers have points: they go into meshes, options and tables.
awk() {
    LC_NUMERIC=C command awk "$@"
}

if ! declare -F require >/dev/null; then
    sort_as_c
    SCRIPTS=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
    declare -A REQUIRED_PARTS=()

    # require PART...
    require() {
        local part
        for part in "$@"; do
            [[ -z ${REQUIRED_PARTS[$part]:-} ]] || continue
            REQUIRED_PARTS[$part]=yes
            # shellcheck source=/dev/null
            source "$SCRIPTS/$part.sh"
        done
    }
fi
require "$@"
