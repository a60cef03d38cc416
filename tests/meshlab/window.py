# SPDX-License-Identifier: GPL-3.0-or-later
"""./run opens several meshes and projects in one window, each layer with its lines, whatever their files are called, and
with the user's settings, which it does not keep; of what cannot be opened it says which one and why."""
import gzip

from harness import *
from product.meshlab import open_window, settings_commands


def project(file, *meshes):
    layers = "".join(f'<MLMesh label="{number}" filename="{mesh}"><MLMatrix44>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MLMatrix44>'
                     "</MLMesh>\n" for number, mesh in enumerate(meshes))
    pathlib.Path(file).write_text(f"<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n<MeshGroup>\n{layers}</MeshGroup>\n"
                                  "<RasterGroup/>\n</MeshLabProject>\n")


def expect_window(code, names, *commands, said="", up=None):
    """A window of these, in which the driver then does this."""
    shutil.rmtree("window", ignore_errors=True)
    os.mkdir("window")
    ended = said_by(open_window, STAGE, WORK / "window", names, commands, up)
    expect(ended == code, f"it ended with {ended} instead of {code}: {text_of('log')}")
    expect_text("log", said)


def kept():
    """What MeshLab has kept of the decoration's parameters."""
    return sorted(line for line in text_of("home/.config/VCG/MeshLab_64bit_fp.conf").splitlines() if "LaplacianLines" in line)


torus()
os.mkdir("odd")
odd = "it's \"a & b\" ü %1 $HOME.ply"
write_mesh(f"odd/{odd}", 30, 20)
latin = "odd/" + os.fsdecode(b"caf\xe9\n.ply")
write_mesh(latin, 20, 20)
with gzip.open("packed.ply.gz", "wb") as packed:
    packed.write(open("torus.ply", "rb").read())
ply("point.ply", ["0 0 0"])
scene = 'odd/a "scene" & more ü.mlp'
project(scene, "../torus.ply", "../point.ply")
os.environ["LC_ALL"] = "C.UTF-8"
layers = [line for number in range(4) for line in (f"select-layer {number}", "expect-action Laplacian Lines checked")]
expect_window(0, ["torus.ply", f"odd/{odd}", latin, "packed.ply.gz"], *layers, "leave")
expect_text("window/log", rf"Laplacian Lines: {re.escape(odd)}: computed with the default options in [0-9.]+ s")
before = kept()
expect(before, "MeshLab keeps no parameters of the decoration")
expect_window(0, [scene, "torus.ply"], *settings_commands(BUILD, ["Detail=100", "line_color=red"]), "size 500x400",
              "expect-action Laplacian Lines checked", f"grab {WORK}/red.png", "select-layer 1",
              "expect-action Laplacian Lines unchecked", "expect-log 1: The mesh has no triangle", "leave")
expect_window(0, ["torus.ply", scene], "select-layer 0", "expect-action Laplacian Lines checked", "leave")
expect_text("window/log", "Laplacian Lines: torus.ply: computed")  # of the first document
expect(red_pixels("red.png") > 100, "the settings do not count")
expect(kept() == before, "what was set for one window is kept")
expect(said_by(settings_commands, BUILD, ["Detail=70", "Detail=abc"]) == 1, "abc is taken")
expect_text("log", '^laplacian-lines: "Detail" is abc. It has to be between 0 and 100.$')

# what is higher along z stands, and its parameters are in sight; no surface is nothing to turn
box("tall.ply", (0, 0, 0), (1, 1, 4))
for axis, is_upright in ((None, True), ("z", True), ("y", False)):
    expect_window(0, ["tall.ply"], "expect-open-parameters", "setdeco Surface = Paper", "check Show Trackball off",
                  "check Show Info Panel off", f"grab {WORK}/tall.png", "leave", up=axis)
    width, height = map(int, convert("tall.png", "-trim", "-format", "%w %h").split())
    expect((height > 2 * width) == is_upright, f"with {axis} up, the picture is {width} x {height}")
expect_window(0, ["point.ply"], "leave")

project("incomplete.mlp", "torus.ply", "missing.ply")
expect_window(1, ["torus.ply", "incomplete.mlp"], said="incomplete.mlp: MeshLab cannot open the project: .*missing.ply")
pathlib.Path("broken.ply").write_text("no mesh\n")
expect_window(1, ["torus.ply", "broken.ply"], said="broken.ply: MeshLab cannot read it")
pathlib.Path("odd\n.mlp").touch()
expect_window(1, ["odd\n.mlp"], said="rename it or its folder")
