#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What scripts match is the same in any country.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere\n' >"$work/CMakeCache.txt"
require=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh

for name in C tr_TR de_DE ja_JP; do
    [[ $name == C ]] || localedef -i "$name" -f UTF-8 "$work/$name.UTF-8" 2>/dev/null || {
        echo "the locale $name cannot be made here" >&2
        exit 77
    }
    locale=$name
    [[ $name == C ]] || locale=$name.UTF-8
    found=$(LOCPATH=$work LC_ALL=$locale bash -c "source '$require' environment/build
        cached '$work' CMAKE_HOME_DIRECTORY; printf '%s\n' b C a B | sort; awk 'BEGIN { print 1 / 2 }'; echo \"\$LC_MESSAGES\"")
    [[ $found == $'/somewhere\nB\nC\na\nb\n0.5\n'"$locale" ]] || {
        printf 'in %s: %s\n' "$name" "$found" >&2
        exit 1
    }
done
