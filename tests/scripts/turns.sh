#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Two scripts that build in one folder: the second says so and waits, can be stopped meanwhile, and gets its turn when the
# first ends, however it ends.
set -euo pipefail

scripts=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../scripts")
# shellcheck source=/dev/null
source "$scripts/require.sh" environment/messages
work=$(mktemp -d)
declare -a begun=()
end_test() {
    for process in "${begun[@]}"; do kill -KILL "$process" 2>/dev/null || true; done
    rm -rf "$work"
}
trap end_test EXIT

# begin NAME [COMMAND [LATER]]: a script that takes its turn, tells so in NAME.has, runs COMMAND, ends its turn, tells so in
# NAME.done and goes on with LATER; sets PROCESS
begin() {
    # shellcheck disable=SC2016 # for that script
    bash -euc 'source "$1" environment/turns
        take_turn "$2/build"; touch "$2/$3.has"; eval "$4"; end_turn; touch "$2/$3.done"; eval "$5"' \
        bash "$scripts/require.sh" "$work" "$1" "${2:-:}" "${3:-:}" 2>"$work/$1.log" &
    PROCESS=$!
    begun+=("$PROCESS")
}

# await CONDITION...: as test takes it
await() {
    until test "$@"; do sleep 0.05; done
}

# a folder of somebody else's, here one that cannot be made
touch "$work/file"
! (bash -euc 'source "$1" environment/turns; take_turn "$2/file/build"' bash "$scripts/require.sh" "$work") 2>"$work/log" ||
    fail "a turn in a folder that cannot be made"
[[ $(wc -l <"$work/log") == 1 ]] && grep -q "cannot be written into" "$work/log" || fail "it says: $(<"$work/log")"

forever='while :; do sleep 0.1; done'
begin first "$forever"
first=$PROCESS
await -e "$work/first.has"

begin stopped
await -s "$work/stopped.log"
kill "$PROCESS"
! wait "$PROCESS" || fail "a script that waits cannot be stopped"
[[ ! -e $work/stopped.has ]] || fail "two scripts have their turn at once"

begin second
await -s "$work/second.log"
grep -q "another run is building in $work/build: waiting" "$work/second.log" || fail "nothing says that it waits"
[[ ! -e $work/second.has ]] || fail "two scripts have their turn at once"
kill -KILL "$first"
wait "$PROCESS" || fail "the turn does not end with the script that has it"
[[ -e $work/second.done ]] || fail "the second script has not done its work"

begin third : "$forever"
await -e "$work/third.done"
begin fourth
wait "$PROCESS"
[[ ! -s $work/fourth.log ]] || fail "a turn does not end"
