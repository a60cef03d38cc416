# SPDX-License-Identifier: GPL-3.0-or-later
"""Users do things in any order: whatever they do, lines are those of the mesh and the camera or the log says why there
are none, OpenGL's state is left alone, and MeshLab goes on. RANDOM_SEEDS="1 2 3" and RANDOM_ACTIONS=300 say what to
try."""
import harness
from harness import *

harness.SECONDS = float(os.environ.get("RANDOM_SECONDS", 3000))
# small, because thousands of fields are computed
write_mesh("torus.ply", 28, 20)
write_mesh("ring.ply", 16, 12)
ply("points.ply", ["0 0 0", "1 0 0", "0 1 0"])
ply("pyramid.ply", ["0 0 1", "1 1 0", "-1 1 0", "-1 -1 0", "1 -1 0"], ["3 0 1 2", "3 0 2 3", "3 0 3 4", "3 0 4 1"])
project("scene.mlp", "ring.ply", ("torus.ply", 3))
for seed in os.environ.get("RANDOM_SEEDS", "1 2").split():
    # a view can be split if both halves are larger than 400 pixels
    drive(f"""wait
open torus.ply
size 820x820
check Laplacian Lines on
random-actions {seed} {os.environ.get("RANDOM_ACTIONS", 60)} torus.ply ring.ply torus.ply pyramid.ply points.ply
leave
""")
    os.link("log", f"log_{seed}")
    expect_text("log", "are the core")
    os.unlink("log")
