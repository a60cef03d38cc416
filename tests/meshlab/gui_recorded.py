# SPDX-License-Identifier: GPL-3.0-or-later
"""A script that was saved after both dialogs draws another mesh, without a window, from where the first was seen."""
from harness import *

torus()
drive(f"""wait
open torus.ply
size 800x600
look 3 1 6  0 0 0
trigger Export Laplacian Lines Drawing
apply
close
trigger Generate Laplacian Lines Polylines
apply
close
trigger Show current filter script
expect-modal .*
button Save Script
set-modal File name: = {os.getcwd()}/recorded.mlx
button Close
""")
os.makedirs("scans", exist_ok=True)
shutil.copy("torus.ply", "scans/next.ply")
expect(serve("-i", "scans/next.ply", "-s", "recorded.mlx") == 0, "the recorded script is refused without a window")
expect(is_file("scans/next_drawing.svg"), "it drew something else")
expect_text("scans/next_drawing.svg", ">perspective, not to scale")
expect_text("log", "perspective, from the viewpoint 3 1 [56]")
