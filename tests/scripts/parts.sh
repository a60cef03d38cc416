#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Each part of the scripts requires what it uses, and is read once; no two have functions of the same name.
set -euo pipefail

scripts=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../scripts")

# functions_with PART: all that are there when nothing but PART is required
functions_with() {
    bash -euc 'source "$1" "$2"; compgen -A function' bash "$scripts/require.sh" "$1" | sort
}

# names_in FILE: all words outside comments and strings
names_in() {
    sed -E "s/^ *#.*//; s/ # .*//; s/\"[^\"\$]*\"//g; s/'[^']*'//g" "$1" | grep -oE '[a-z][a-z_]+' | sort -u
}

twice=$(grep -hoE '^[a-z_]+\(\)' -r "$scripts" --include='*.sh' | sort | uniq -d)
[[ -z $twice ]] || {
    printf 'two parts have a function %s\n' "${twice//$'\n'/ }"
    exit 1
}
functions=$(grep -hoE '^[a-z_]+\(\)' -r "$scripts" --include='*.sh' | tr -d '()' | sort -u)
failed=false
while read -r part; do
    there=$(functions_with "$part") || exit 1
    missing=$(comm -23 <(names_in "$scripts/$part.sh" | comm -12 - <(printf '%s\n' "$functions")) <(printf '%s\n' "$there"))
    [[ -z $missing ]] || {
        printf '%s does not require what it uses: %s\n' "$part" "${missing//$'\n'/ }"
        failed=true
    }
done < <(cd "$scripts" && find . -mindepth 2 -name '*.sh' -printf '%P\n' | sed 's/\.sh$//')
if $failed; then exit 1; fi

[[ $(bash -euc 'source "$1" "$2"; say() { echo unread; }; require "$2"; say' bash "$scripts/require.sh" environment/messages) == unread ]] || {
    echo "a part is read twice"
    exit 1
}
