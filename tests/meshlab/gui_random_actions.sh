#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Users do things in any order: whatever they do, lines are those of the mesh and the camera or the log says why there
# are none, OpenGL's state is left alone, and MeshLab goes on.
#   RANDOM_SEEDS="1 2 3", RANDOM_ACTIONS=300: what to try
DRIVE_SECONDS=${RANDOM_SECONDS:-3000}
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# small, because thousands of fields are computed
write_bumpy_torus 28 20 >"$WORK/torus.ply"
write_bumpy_torus 16 12 >"$WORK/ring.ply"
ply "$WORK/points.ply" 3 0 <<<$'0 0 0\n1 0 0\n0 1 0'
ply "$WORK/pyramid.ply" 5 4 <<<$'0 0 1\n1 1 0\n-1 1 0\n-1 -1 0\n1 -1 0\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1'

cat >"$WORK/scene.mlp" <<'END'
<!DOCTYPE MeshLabDocument>
<MeshLabProject>
 <MeshGroup>
  <MLMesh label="ring.ply" filename="ring.ply"><MLMatrix44>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MLMatrix44></MLMesh>
  <MLMesh label="torus.ply" filename="torus.ply"><MLMatrix44>1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1</MLMatrix44></MLMesh>
 </MeshGroup>
 <RasterGroup/>
</MeshLabProject>
END

# a view can be split if both halves are larger than 400 pixels
for seed in ${RANDOM_SEEDS:-1 2}; do
    drive <<END
wait
open torus.ply
size 820x820
check Laplacian Lines on
random-actions $seed ${RANDOM_ACTIONS:-60} torus.ply ring.ply torus.ply pyramid.ply points.ply
leave
END
    cp "$WORK/log" "$WORK/log_$seed"
    grep 'are the core' "$WORK/log"
done
