#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The example script in MeshLab's own script dialog gives the core's results.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

reference_mesh torus
drive < <(
    cat <<END
wait
open torus.ply
trigger Show current filter script
expect-modal .*
button Open Script
set-modal File name: = $EXAMPLE
button Apply Script
END
    save_attributes on
)
expect_reference_attributes "$WORK/torus.ply"
