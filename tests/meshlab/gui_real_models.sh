#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A scanned model of a quarter of a million triangles, where there is one beside the repository.
export DRIVE_SECONDS=250
source "$(dirname "$(readlink -f "$0")")/harness.sh"

MODEL=$(dirname "$(readlink -f "$0")")/../../../shared/models/igea.ply.gz
if [[ ! -r $MODEL ]]; then
    say "skipped: there is no shared/models/igea.ply.gz beside the repository"
    exit 77
fi

gunzip -c "$MODEL" >"$WORK/igea.ply"
drive_lines igea.ply <<'END'
time-limit 120
expect-lines
grab front.png
drag 0.5 0.5 0.8 0.55
expect-lines
grab side.png
wheel -6
expect-lines
trigger Toggle Orthographic Camera
expect-lines
trigger Toggle Orthographic Camera
trigger Compute Laplacian Lines
set Normal Smoothing Sigma = 2
apply
close
expect-lines normal_sigma=2
expect-other-lines
expect-no-log changed since
END
