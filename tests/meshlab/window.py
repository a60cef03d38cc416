# SPDX-License-Identifier: GPL-3.0-or-later
"""./run opens several meshes and projects in one window, each layer with its lines, whatever their files are called; of
what cannot be opened it says which one and why."""
import gzip

from harness import *
from product.meshlab import open_window


def expect_window(code, names, commands=(), said=""):
    """A window of these, in which the driver then does this."""
    shutil.rmtree("window", ignore_errors=True)
    os.mkdir("window")
    ended = said_by(open_window, STAGE, WORK / "window", names, [*commands, "quit"])
    expect(ended == code, f"it ended with {ended} instead of {code}: {text_of('log')}")
    expect_text("log", said)


def lines_of_layers(count):
    """The commands that look at each layer's lines alone."""
    return ["check Show Info Panel off", "check Show Trackball off", "size 500x400", "setdeco Line Color = #ff0000",
            "setdeco Contour Color = #ff0000", "slot view resetTrackBall",
            *(word for layer in range(count) for word in (f"select-layer {layer}", "check Laplacian Lines Probe on")),
            "expect-lines",
            *(word for layer in range(count - 1) for word in (f"show-layer {layer}", "expect-lines")),
            f"show-layer {count - 1}",
            "expect-no-lines"]


small_torus()
os.mkdir("odd")
odd = "it's \"a & b\" ü %1 $HOME.ply"
write_mesh(f"odd/{odd}", 30, 20)
latin = "odd/" + os.fsdecode(b"caf\xe9\n.ply")
write_mesh(latin, 20, 20)
with gzip.open("packed.ply.gz", "wb") as packed:
    packed.write(open("torus.ply", "rb").read())
os.environ["LC_ALL"] = "C.UTF-8"
expect_window(0, ["torus.ply", f"odd/{odd}", latin, "packed.ply.gz"], lines_of_layers(4))
expect_text("window/log", rf"Laplacian Lines: {re.escape(odd)}: computed with the default options in [0-9.]+ s")

scene = 'odd/a "scene" & more ü.mlp'
project(scene, "../torus.ply", odd)
expect_window(0, [scene], lines_of_layers(2))
expect_window(0, [scene, "torus.ply"], lines_of_layers(3))

ply("point.ply", ["0 0 0"])
project("points.mlp", "point.ply", "torus.ply")
expect_window(0, ["points.mlp"], ["expect-action Laplacian Lines checked", "select-layer 0",
                                  "expect-action Laplacian Lines unchecked",
                                  "expect-log point.ply: The mesh has no triangle"])

project("incomplete.mlp", "torus.ply", "missing.ply")
expect_window(1, ["torus.ply", "incomplete.mlp"], said="incomplete.mlp: MeshLab cannot open the project: .*missing.ply")
pathlib.Path("broken.mlp").write_text("no project\n")
expect_window(1, ["broken.mlp"], said="broken.mlp: MeshLab cannot open the project")
expect_window(1, ["torus.ply", "broken.mlp"], said="broken.mlp: MeshLab cannot open the project")
pathlib.Path("broken.ply").write_text("no mesh\n")
expect_window(1, ["torus.ply", "broken.ply"], said="broken.ply: MeshLab cannot read it")
pathlib.Path("odd\n.mlp").touch()
expect_window(1, ["odd\n.mlp"], said="rename it or its folder")
