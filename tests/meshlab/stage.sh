#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sets up the MeshLab that the other tests run, with the plugins just built.
set -euo pipefail

# shellcheck source=/dev/null
source "$(dirname "$(readlink -f "$0")")/../../scripts/require.sh" product/stage

shopt -s nullglob # a build without one of the plugins is still worth testing
stage_meshlab "$LAPLACIAN_LINES_BUILD/stage" \
    "$LAPLACIAN_LINES_BUILD"/plugins/*.so "$LAPLACIAN_LINES_BUILD"/driver/*.so
