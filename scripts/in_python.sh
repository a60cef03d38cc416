#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# in_python.sh COMMAND ARGS...: runs COMMAND.py here, and installs Python where there is none.
say() { printf 'laplacian-lines: %s\n' "$*" >&2; }

if ! command -v python3 >/dev/null; then
    command -v apt-get >/dev/null || { say "this needs the package python3, and there is no apt-get to install it" && exit 1; }
    say "installing python3"
    [ "$(id -u)" = 0 ] && sudo='' || sudo=sudo
    command -v "${sudo:-env}" >/dev/null ||
        { say "neither root nor sudo is at hand; as root, run: apt-get install python3" && exit 1; }
    $sudo apt-get -qq update || say "apt-get update failed; trying with the package lists at hand"
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install python3 >/dev/null ||
        { say "could not install python3" && exit 1; }
fi
command=$1
shift
python=/usr/bin/python3 # version managers put a script before it, which takes longer than ours
[ -x "$python" ] || python=python3
# -B: no files beside the sources, or they look changed; -S: no packages are needed
exec "$python" -BS "${0%/*}/$command.py" "$@"
