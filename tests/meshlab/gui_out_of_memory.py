# SPDX-License-Identifier: GPL-3.0-or-later
"""Without enough memory, the filter and the decoration say so, the mesh stays as it is, and MeshLab goes on."""
from harness import *

if not os.environ.get("OUT_OF_MEMORY"):
    # Qt itself now and then fails to paint MeshLab's window with so little memory, in newer versions always
    say("skipped: set OUT_OF_MEMORY=1 to run it")
    sys.exit(77)
# what is freed goes back to the system at once, else the limit would not be one
os.environ.update(MALLOC_ARENA_MAX="1", MALLOC_MMAP_THRESHOLD_="65536")
write_mesh("torus.ply", 500, 300)
# MeshLab's first filter makes an OpenGL context, for which Mesa needs memory, or crashes
BEGIN = """wait
open torus.ply
size 500x400
check Fill off
check Points on
trigger Invert Faces Orientation
set Force Flip = on
apply
close
"""
drive(BEGIN + r"""trigger Compute Laplacian Lines
limit-memory 2
apply
expect-modal Filter Failure.*Not enough memory\. The mesh was not changed
unlimit-memory
button OK
apply
close
expect-log (?s)Not enough memory.*Computed in
""")
drive(BEGIN + """limit-memory 2
check Laplacian Lines on
unlimit-memory
expect-log Laplacian Lines: torus.ply: There is not enough memory for the lines of this mesh
expect-action Laplacian Lines unchecked
check Laplacian Lines on
expect-action Laplacian Lines checked
""")
