#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A signal to a script alone ends it at once while it waits for a build, with the code that shells give it, and with all
# that the build has begun.
set -euo pipefail

require=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")/../../scripts/require.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/script" <<END
source "$require" environment/messages
build() {
    sleep 600 &
    echo "\$!" >"$work/sleeping"
    wait
}
end_at_signals 'touch "$work/tidied"'
quietly "$work/log" build
END

# expect_code CODE SIGNAL
expect_code() {
    local script code=0 begin
    rm -f "$work/sleeping" "$work/tidied"
    env --default-signal=INT bash "$work/script" &
    script=$!
    until [[ -s $work/sleeping ]]; do sleep 0.05; done
    begin=$SECONDS
    kill "-$2" "$script"
    wait "$script" || code=$?
    ((code == $1)) || { echo "the code after SIG$2 is $code" >&2 && exit 1; }
    ((SECONDS - begin <= 2)) || { echo "SIG$2 is obeyed after $((SECONDS - begin)) s" >&2 && exit 1; }
    [[ -e $work/tidied ]] || { echo "after SIG$2 nothing was tidied up" >&2 && exit 1; }
    for ((i = 0; i < 40; ++i)); do
        kill -0 "$(<"$work/sleeping")" 2>/dev/null || return 0
        sleep 0.05
    done
    echo "after SIG$2 the build goes on" >&2
    exit 1
}

expect_code 143 TERM
expect_code 130 INT
