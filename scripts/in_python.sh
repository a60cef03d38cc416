#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# in_python.sh COMMAND ARGS...: runs COMMAND.py here, and installs Python where there is none.
if ! command -v python3 >/dev/null; then
    echo "laplacian-lines: installing python3" >&2
    [ "$(id -u)" = 0 ] && sudo='' || sudo=sudo
    $sudo apt-get -qq update >&2
    $sudo apt-get -qq -y --no-install-recommends install python3 >&2 ||
        { echo "laplacian-lines: could not; as root, run: apt-get install python3" >&2 && exit 1; }
fi
command=$1
shift
python=/usr/bin/python3 # version managers put a script before it, which takes longer than ours
[ -x "$python" ] || python=python3
# -B: no files beside the sources, or they look changed; -S: no packages are needed
exec "$python" -BS "${0%/*}/$command.py" "$@"
