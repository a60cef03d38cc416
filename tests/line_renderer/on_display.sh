#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# on_display.sh COMMAND ARGS...: runs a command on a virtual display with OpenGL in software
set -euo pipefail

# shellcheck source=/dev/null
source "$(dirname "$(readlink -f "$0")")/../../scripts/require.sh" product/display

trap stop_display EXIT
trap 'exit 143' TERM INT
start_display 640 480
export LIBGL_ALWAYS_SOFTWARE=1
"$@"
