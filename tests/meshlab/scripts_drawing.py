# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings in scripts: the example, the same bytes as from ./run --drawing but for what they say of
their making, and errors."""
from harness import *

EXAMPLE, PROGRAM = "laplacian_lines_drawing.mlx", BUILD / "bin/laplacian-lines"
# what is built for PyMeshLab's tests has no program: nothing is compared there
VERSION = output(PROGRAM, "--version").split()[1] if PROGRAM.exists() or "MESH_SERVER" not in os.environ else ""


def without_provenance(file):
    if file.endswith(".pdf"):
        return output("pdftocairo", "-svg", file, "-")
    if file.endswith(".png"):
        return output("convert", file, "-strip", "ppm:-", encoding="latin-1")
    lines = text_of(file).splitlines()
    if file.endswith(".dxf"):  # comments, of two lines each
        return [line for before, line in zip(["", *lines], lines) if "999" not in (before, line)]
    return [line for line in lines if "<metadata>" not in line]


def draw(file, *options, meshes=("torus.ply",), compare=True, **settings):
    """By the script with the settings, and the same by ./run --drawing with the options."""
    filter_script(EXAMPLE, {"file": file, **settings})
    pathlib.Path(file).unlink(missing_ok=True)
    code = serve("-i", *meshes, "-s", "script.mlx")
    expect(code == 0 and is_file(file), f"the script with {settings} ended with {code}")
    if compare and VERSION:
        output(PROGRAM, f"program_{file}", *options, *meshes)
        expect(f'laplacian_lines":"{VERSION}"'.encode() in pathlib.Path(file).read_bytes(),
               f"{file} does not tell the version")
        expect(without_provenance(file) == without_provenance(f"program_{file}"),
               f"{file} differs from what --drawing {options} writes")


torus()
draw("front.svg")
expect_text("log", r"Inner lines have a kernel of √h = [0-9.]* mm on paper")
expect_text("log", r"Drawing of torus\.ply: /.*/front\.svg, scale 50:1 on paper of 210 x 297 mm\. "
            r"The object is 2\.[0-9]* x 2\.[0-9]* x .* mm in size, with 1 mm to the unit")
draw("plate.dxf", *"--views six --paper a3 --unit cm --up z --title Torus --arrangement third".split(),
     views="six", paper=2, unit=1, up=2, title="Torus", arrangement=1)
expect_text("log", r"plate\.dxf, scale .* on paper of (297 x 420|420 x 297) mm\. .*, with 10 mm to the unit")
draw("cut.svg", *"--views top,30,15 --section x=0.5 --section y=0.4 --scale 10:1 --annotations none --paper fit".split(),
     views="top,30,15", sections="x=0.5 y=0.4", scale="10:1", annotations="false", paper=6)
expect_text("log", "scale 10:1 on paper of")
draw("section.svg", *"--views left --section z=0.5 --wall filled".split(), views="left", sections="z=0.5", wall=1)
draw("alone.svg", "--section", "z=0.5", views="", sections="z=0.5")
draw("plate.pdf", "--views", "front,left", "--title", "A plate", views="front,left", title="A plate")
expect(open("plate.pdf", "rb").read(5) == b"%PDF-", "plate.pdf is not a PDF")
# kinds of lines by mixtures, whose numbers are those of Settings
draw("ridges.svg", "--kinds", "apparent_ridges", settings=5)
expect(not same_file("ridges.svg", "front.svg"), "apparent ridges look like the usual lines")
draw("plate.png", "--views", "six", views="six")
draw("hidden.svg", *"--views 30,40 --hidden dashed".split(), views="30,40", hidden=1)
draw("iso.svg", *"--views 30,40 --weights iso".split(), views="30,40", weights=1)

# places of the mesh in names; a drawing of another mesh is kept
os.makedirs("scans", exist_ok=True)
for name in ("a.ply", "a.stl.ply"):
    shutil.copy("torus.ply", f"scans/{name}")
    filter_script(EXAMPLE, {"file": "{folder}/{name}_1.svg", "title": "Find {name}"})
    expect(serve("-i", f"scans/{name}", "-s", "script.mlx") == 0, "places in names are refused")
    expect_text(f"scans/{name[:-4]}_1.svg", f">Find {name[:-4]}<")
    for file in ("scans/same.svg", "scans/same%1.png"):
        filter_script(EXAMPLE, {"file": file})
        for _ in range(2):
            expect(serve("-i", f"scans/{name}", "-s", "script.mlx") == 0, "the same name twice is refused")
expect_text("scans/same.svg", ">[^<]*a\\.ply<")
expect_text("scans/same_2.svg", ">[^<]*a\\.stl\\.ply<")
expect(os.path.exists("scans/same%1_2.png"), "the drawing of another mesh is replaced")
for file in ("scans/same_3.svg", "scans/same%1_3.png"):
    expect(not os.path.exists(file), "a drawing of the same mesh is not replaced")

# layers together
ply("points.ply", ["0 0 9"])
lines = [line.split() for line in text_of("torus.ply").split("end_header\n")[1].splitlines()]
ply("behind.ply", [f"{float(x) + .9} {float(y) + .3} {float(z) - 2}" for x, y, z in lines[:12800]],
    [" ".join(face) for face in lines[12800:]])
two = {"layers": 1, "views": "front,20,10", "sections": "x=0.5", "hidden": 1}
draw("two.svg", *"--views front,20,10 --section x=0.5 --hidden dashed".split(), meshes=("torus.ply", "behind.ply"),
     **two)
expect_text("log", r"Drawing of torus\.ply, behind\.ply: .*two\.svg, .* Together the objects are 3\.[0-9]* x")
draw("both.svg", meshes=("points.ply", "torus.ply", "behind.ply"), compare=False, **two)
expect_text("log", r"points\.ply is left out of the drawing: it has no faces\.")
expect(same_file("both.svg", "two.svg"), "points change the drawing")
draw("current.svg", meshes=("torus.ply", "behind.ply"), compare=False)
expect_text("current.svg", r">[^<]*behind\.ply<")
expect_no_text("current.svg", r"torus\.ply")

# a field of other options is used
filter_script("laplacian_lines.mlx", {"kernel_size": 0.2}, "field.mlx")
filter_script(EXAMPLE, {"file": "coarse.svg"})
pathlib.Path("both.mlx").write_text(text_of("field.mlx").replace("</FilterScript>", "") +
                                    re.search("(?s)<filter .*", text_of("script.mlx"))[0])
expect(serve("-i", "torus.ply", "-s", "both.mlx") == 0, "both filters after each other fail")
expect_no_text("log", "computed with the default options")
expect(not same_file("coarse.svg", "front.svg"), "the attributes make no difference")

refuse(r'"plate\.bmp" does not end in \.svg', EXAMPLE, file="plate.bmp")
refuse(r'"missing.drawing\.svg" cannot be written', EXAMPLE, file="missing/drawing.svg")
for key, value, reason in (
        ("scale", "1000:1", "At the scale 1000:1 the views take .* Take the scale "),
        ("scale", "half", '"half" is not a scale'),
        ("views", "above", '"above" is not a view'),
        ("sections", "y", '"y" is not a section'),
        ("views", "window", "There is no window whose view could be drawn"),
        ("settings", 1, "The decoration Laplacian Lines has drawn nothing here"),
        ("unit", 4, r'"Unit of the Mesh" is 4\. It has to be one of 0 \(mm\)')):
    refuse(reason, EXAMPLE, file="refused.svg", **{key: value})
    expect(not os.path.exists("refused.svg"), f"a drawing was written with {key} {value}")
