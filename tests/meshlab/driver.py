# SPDX-License-Identifier: GPL-3.0-or-later
"""The other tests rely on the driver: to notice what goes wrong, and to do what it says."""
from harness import *

small_torus()
pathlib.Path("broken.ply").write_text("not a mesh\n")
os.mkfifo("still.off")
for regex, *commands in (
        ("line 2: jump: unknown command 'jump'", "jump"),
        ("line 2: open nothing.ply: MeshLab says: .*does not exist", "open nothing.ply", "sleep 500"),
        ("line 2: open broken.ply: MeshLab says: (Opening Failure|Meshlab Opening Error)", "open broken.ply"),
        ("line 3: trigger No Such Filter: no action 'No Such Filter'", "open torus.ply", "trigger No Such Filter"),
        ("line 4: set No Such Field = 1: no field 'No Such Field' among .*'Smoothing steps'", "open torus.ply",
         "trigger Laplacian Smooth", "set No Such Field = 1"),
        ("line 3: expect-modal .*: time-out after 1", "time-limit 1", "expect-modal a box that never comes"),
        ("line 3: load still.off: time-out after 1", "time-limit 1", "load still.off"),
        ("line 4: expect-log no such text: the log does not say so", "open torus.ply", "expect-log Opened mesh",
         "expect-log no such text")):
    drive_to_failure(regex, "\n".join(["wait", *commands]))

# and that it does its work
drive("""wait
open torus.ply
check Show Info Panel off
size 500x400
check Show Normal on
setdeco Vector Length = 0.02
setdeco Curr Vert Normal Color = #ff0000
look 0 0 3  0 0 0
grab normals.png
save-camera camera.xml
look 3 0 1  0 0 0  0 0 1
camera camera.xml
grab again.png
snapshot tiled.png 2
trigger Laplacian Smooth
set Smoothing steps = 2
apply
close
expect-log Smoothed
trigger Save snapshot
expect-modal Snapshot|Save
button Cancel
open torus.ply
select-layer 1
delete-layer 1
expect-log Delete Current Mesh
trigger Toggle Orthographic Camera
look 3 0 1  0 0 0  0 0 1
wheel 2
drag 0.4 0.5 0.6 0.5
grab orthographic.png
size 600x700
trigger Horizontally
expect-views 2
view 0
trigger Close current view
expect-views 1
# what was said in the document that is left
trigger New Empty Project...
open torus.ply
trigger Close Project
expect-log Smoothed
""")
expect_picture("normals.png", "500x400")
expect_picture("tiled.png", "1000x800")
expect_same_picture("normals.png", "again.png", 50)  # cameras travel as text of a few digits
