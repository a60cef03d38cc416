# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab's snapshots have the lines. Those put together from tiles, which show a part of the camera's view each, are
the picture of a view so much larger, with lines so much wider: then the print looks like the view."""
from harness import *

# Visibility is that of the view, which looks at fewer pixels beside a line than a larger one; that is a few hundred
# pixels.
MOST_DIFFERING = 2000


def larger(name, factor):
    """What a snapshot of factor by factor tiles has to look like."""
    return f"""size {400 * factor}x{300 * factor}
setdeco Line Width = {1.6 * factor:g}
grab {name}.png
setdeco Line Width = 1.6
size 400x300
"""


def snapshots(name):
    tiles = "".join(f"snapshot {name}_{n}.png {n}\n" for n in (1, 2, 3))
    return f"grab {name}.png\n{tiles}grab {name}_again.png\n"


torus()
drive_lines("torus.ply", f"""size 400x300
look 2.2 0.5 2.2  0 0 0
expect-lines
{snapshots("perspective")}
{larger("perspective_view_2", 2)}
{larger("perspective_view_3", 3)}
expect-lines
# another camera, not drawn before
look 1.9 0.9 2.2  0 0 0
snapshot unseen.png 2
{larger("unseen_view", 2)}
trigger Toggle Orthographic Camera
{snapshots("orthographic")}
{larger("orthographic_view_2", 2)}
{larger("orthographic_view_3", 3)}
trigger Toggle Orthographic Camera
check Points on
check Fill off
setdeco Surface = Paper
setdeco Hidden Lines = Dashed
{snapshots("dashed")}
""")


def redness(file):
    """Share of the picture that is red and neither white nor grey."""
    return float(convert(file, "-alpha", "off", "-format", "%[fx:mean.r-mean.g]"))


# A camera that differs in the last bits may have other points of a line left out, which changes its tone by a shade.
for view in ("perspective", "orthographic", "dashed"):
    expect_same_picture(f"{view}.png", f"{view}_1.png", 150)
    expect_same_picture(f"{view}.png", f"{view}_again.png", 10)
    for tiles in (2, 3):
        # lines are as wide in the view as in the snapshot brought down to its size; without their widths growing it
        # would have a half or a third of the red
        seen, printed = redness(f"{view}.png"), redness(f"{view}_{tiles}.png")
        expect_between(0.96, seen / printed, 1 / 0.96, f"red of the view {view} to that of {tiles} by {tiles} tiles")
        if view != "dashed":
            expect_same_picture(f"{view}_view_{tiles}.png", f"{view}_{tiles}.png", MOST_DIFFERING)
expect_same_picture("unseen_view.png", "unseen.png", MOST_DIFFERING)
