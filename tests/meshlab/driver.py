# SPDX-License-Identifier: GPL-3.0-or-later
"""./run and the other tests rely on the driver: to notice what goes wrong, and to say so."""
from harness import *

small_torus()
pathlib.Path("broken.ply").write_text("not a mesh\n")
os.mkfifo("still.off")
for regex, *commands in (
        ("line 3: jump: unknown command 'jump'", "load torus.ply", "jump"),
        ("line 2: load broken.ply: MeshLab cannot read it: (Opening Failure|Meshlab Opening Error)", "load broken.ply"),
        ("line 5: set No Such Field = 1: no field 'No Such Field' among .*'Smoothing steps'", "load torus.ply",
         "expect-log Opened mesh", "trigger Laplacian Smooth", "set No Such Field = 1"),
        ("line 3: load still.off: time-out after 1 s", "time-limit 1", "load still.off")):
    drive_to_failure(regex, "\n".join(["wait", *commands]))
