# SPDX-License-Identifier: GPL-3.0-or-later
"""program.py PROGRAM: what the program of drawings makes of meshes and of mistakes, and how large others' programs find
its drawings."""

import filecmp
import re

from harness import *
from environment.messages import skip
from product.models import bumpy_torus

BARE = ("--views", "front", "--strokes", "plain", "--annotations", "none")


def expect_said(said, *texts):
    for text in texts:
        expect(text in said, f'nothing says "{text}": {said}')


def paths(file):
    return text_of(file).count("<path")


write_cube()

# the same bytes by all instruction sets that the processor has
pathlib.Path("torus.ply").write_text(bumpy_torus(160, 80))
for size in "64", "32", "16":
    draw(f"{size}.svg", "--kinds", "all_kinds", "--views", "six", "torus.ply", LAPLACIAN_LINES_VECTOR_BYTES=size)
    expect(filecmp.cmp("64.svg", f"{size}.svg", shallow=False), f"vectors of {size} bytes draw other lines")

for mesh in ("cube.off", "cube.obj", "cube.ply"):
    expect_said(draw(f"{mesh}.svg", *BARE, "--scale", "1:1", mesh), "100.0 x 100.0 x 100.0 mm")
    expect(paths(f"{mesh}.svg") == 1, f"the outline of {mesh} is not one line")

off("points.off", ["0 0 0", "1 0 0", "0 1 0"], [])
write("empty.ply")
pathlib.Path("nonsense.stl").write_text("nonsense")
off("nowhere.off", ["nan nan nan"] * 8)
for sentence, words in (
        ("does not end in", "plate.jpg cube.off"),
        ("name the drawing first, as in laplacian-lines drawing.svg cube.off", "cube.off plate.svg"),
        ("cannot be written", "missing/plate.svg cube.off"),
        ("there is no such file", "plate.svg missing.ply"),
        ("PLY, OBJ, STL and OFF", f"plate.svg {PROGRAM}"),
        ("is not a view", "plate.svg --views above cube.off"),
        ("is not a section", "plate.svg --section y cube.off"),
        ("not a scale", "plate.svg --scale 2 cube.off"),
        ("not a size of detail", "plate.svg --kernel 2 cube.off"),
        ("not a size of detail", "plate.svg --smoothing 0mm cube.off"),
        ("Take the scale 1:1, ", "plate.svg --scale 9:1 cube.off"),
        ("has to be one of", "plate.svg --up w cube.off"),
        ('--kinds is "ridge". It has to be some of usual, laplacian_lines, ', "plate.svg --kinds ridge cube.off"),
        ("unknown option", "plate.svg --colour red cube.off"),
        ("needs a value", "plate.svg cube.off --up"),
        ("Write an SVG or DXF file", "plate.pdf --title 日本 cube.off"),
        ("Write an SVG or DXF file", "plate.png --title 日本 cube.off"),
        ("no faces", "plate.svg points.off"),
        ("empty.ply: the mesh cannot be read", "plate.svg empty.ply"),
        ("nonsense.stl: the mesh cannot be read: it ends within its header.", "plate.svg nonsense.stl"),
        ("no triangle with an area", "plate.svg --damaged draw nowhere.off"),
        ("cannot be written", "/proc/plate.svg cube.off")):
    refused(sentence, *words.split(" "))

# a value may stand behind an equals sign
draw("apart.svg", "--views", "top", "--title", "a=b", "cube.off")
draw("joined.svg", "--views=top", "--title=a=b", "cube.off")
expect(filecmp.cmp("apart.svg", "joined.svg", shallow=False), "--views=top is not --views top")
refused("unknown option --view;", "plate.svg", "--view=top", "cube.off")

# more detail is more lines
lengths = []
for detail in "0", "50", "100":
    draw("detail.svg", *BARE, "--scale", "100:1", "--paper", "fit", "--detail", detail, "torus.ply")
    lengths.append(len(text_of("detail.svg")))
expect(lengths[0] < lengths[1] < lengths[2], f"more detail draws {lengths} bytes")

# faces without a place are a damage, vertices of no face are none; a size that can hardly be meant gives advice
hole = ["nan nan nan" if vertex == "100 100 100" else vertex for vertex in VERTICES]
off("hole.off", hole)
write("hole.obj", *(f"v {vertex}" for vertex in hole),
      *(f"f {' '.join(str(int(word) + 1) for word in face.split())}" for face in FACES))
for file in "hole.off", "hole.obj":
    refused(f"{file}: the file is damaged: 5 of 12 triangles have corners without finite coordinates. With --damaged draw, ",
            "plate.svg", file)
    said = draw("hole.svg", *BARE, "--damaged", "draw", file)
    expect_said(said, f"{file} is drawn incomplete: 5 of 12 triangles", "100.0 x 100.0 x 100.0 mm")
off("unused.off", [*VERTICES, "nan nan nan"])
expect("incomplete" not in draw("unused.svg", *BARE, "unused.off"), "a vertex of no face makes a mesh incomplete")
off("metres.off", moved(1e-5))
expect_said(draw("metres.svg", "--scale", "1:1", "--unit", "m", *BARE, "metres.off"), "1.00 x 1.00 x 1.00 mm in size")
expect_said(draw("metres.svg", *BARE, "metres.off"), "if it is in metres, say --unit m")

# faces that face inwards, or some of them, make no difference, but are told of
turned = [" ".join(reversed(face.split())) for face in FACES]
drawings = set()
for name, faces, remark in (("cube", FACES, ""), ("inverted", turned, "inside out"),
                            ("mixed", [*FACES[:4], *turned[4:]], "8 of 12 triangles face inwards")):
    off(f"{name}/cube.off", VERTICES, faces)
    said = draw("views.svg", "--views", "front,30,30", f"{name}/cube.off")
    expect(remark in said and bool(remark) == ("MeshLab's filter" in said), f"{name}: {said}")
    draw("section.svg", "--section", "x=0.5", f"{name}/cube.off")
    drawings.add((re.sub("<metadata.*?</metadata>", "", text_of("views.svg"), flags=re.S), paths("section.svg")))
expect(len(drawings) == 1, "a cube whose faces face inwards is drawn otherwise")

# texts of PDF can be searched
draw("searched.pdf", "--views", "front", "--title", "Find 17 äöü", "cube.off")
run(["pdftotext", "searched.pdf", "searched.txt"])
expect_said(text_of("searched.txt"), "Find 17 äöü", "100.0 × 100.0 × 100.0 mm")
expect("√h" not in text_of("searched.txt"), "a cube has a detail")
fonts = run(["pdffonts", "searched.pdf"])
expect(re.findall(r"^(\S+) .* (no|yes) +no +no ", fonts, re.M) == [("Helvetica", "no"), ("Symbol", "no")], fonts)
draw("letters.pdf", "--title", "Łódź", "cube.off")  # letters that these fonts do not have are drawn
run(["pdftotext", "letters.pdf", "letters.txt"])
expect("dź" not in text_of("letters.txt") and "100.0 × 100.0" in text_of("letters.txt"), text_of("letters.txt"))

# a damaged file is refused, or drawn and called incomplete
corners = ["vertex 0 0 0", "vertex 100 0 0", "vertex 0 100 0"]
write("cut.stl", "solid cut", *2 * ["facet normal 0 0 1", " outer loop", *corners, " endloop", "endfacet"])
write("cut.stl", *text_of("cut.stl").splitlines()[:10], "vertex 100 0 0", "vertex 100 100")
refused('cut.stl: the file is damaged: line 12: it ends without "endsolid". With --damaged draw, what is whole',
        "plate.svg", "cut.stl")
expect_said(draw("incomplete.svg", "--views", "top", "--up", "z", "--damaged", "draw", "cut.stl"),
            "cut.stl is drawn incomplete: line 12")
expect_said(text_of("incomplete.svg"), "incomplete: cut.stl")
write("half.off", *text_of("cube.off").splitlines()[:12])
refused("half.off: ", "plate.svg", "half.off")
shutil.copy("cube.off", "--dash.off")
draw("dash.svg", *BARE, "--", "--dash.off")

# --- several meshes in a file are one drawing

off("scene/near.off")
off("scene/far.off", moved(x=50, z=-300))
os.mkdir("no_meshes")
together = (*BARE, "--title", "{name}", "--scale", "1:1", "--paper", "a3")
expect_said(draw("together.svg", *together, "scene/near.off", "scene/far.off"),
            "together the objects are 150.0 x 100.0 x 400.0 mm")
# the far one's outline is an angle beside the near one's
expect(paths("together.svg") == 2, "two cubes have other outlines than theirs")
draw("folder.svg", *together, "scene")
draw("order.svg", *together, "scene/far.off", "scene/near.off")
expect(filecmp.cmp("folder.svg", "order.svg", shallow=False), "a folder is not drawn as its meshes")
draw("notes.svg", "--title", "{name}", "scene")
expect_said(text_of("notes.svg"), ">far, near<", "far.off, near.off")
refused("points.off: the mesh has no faces", "plate.svg", "cube.off", "points.off")
refused("nowhere.off: ", "plate.svg", "cube.off", "nowhere.off")
refused("there is no mesh in the folder", "plate.svg", "no_meshes")

# --- several meshes in a folder are a drawing each and a contact sheet

off("meshes/one.off")
off("meshes/two.off", moved(0.5))
write("meshes/bad.ply", "no mesh")
shutil.copytree("meshes", "more")
shutil.move("more/two.off", "more/two.OFF")
for source, target in (("cube.ply", "more/three.ply"), ("cube.obj", "more/one.obj")):
    shutil.copy(source, target)
said = draw("plates/", "meshes", "more/three.ply", code=1)
expect_said(said, *(f"plates/{name}.pdf: drawn\n" for name in ("one", "two", "three")),
            "meshes/bad.ply: not drawn: the mesh cannot be read", "plates/contact_sheet.pdf: 3 objects\n",
            "3 drawn, 1 not drawn\n")
shutil.rmtree("meshes")
os.unlink("more/bad.ply")
expect_said(draw("plates/", "--title", "{name}", "--format", "svg", "more"),
            "plates/one.off.svg: drawn\n", "plates/one.obj.svg: drawn\n", "4 drawn, 0 not drawn\n")
expect_said(text_of("plates/contact_sheet.svg"), *(f">{name}<" for name in ("one.off", "one.obj", "two", "three")))
expect_said(text_of("plates/two.svg"), ">two<")
for sentence, words in (
        ("--format is for a folder", "plate.svg --format pdf cube.off"),
        ("there is no mesh in the folder", "plates/ plates"),
        ("have the same name", "plates/ cube.off more/../cube.off"),
        ("cannot be written", "cube.off/plates/ more"),
        ("between 20 and 2400", "plate.png --dpi 5 cube.off"),
        ("is too large", "plate.png --dpi 2400 --paper a0 cube.off")):
    refused(sentence, *words.split())

expect_said(draw("alone/", "cube.off"), "alone/contact_sheet.pdf: 1 object\n")
draw("deep/folder/", "points.off", code=1)
expect(not os.path.exists("deep"), "a folder without drawings is left")
os.mkdir("mine")
draw("mine/", "points.off", code=1)
expect(os.path.isdir("mine"), "a folder that was there is gone")

# --- names of files are bytes

odd = os.fsdecode(b"caf\xe9 \xff\xc3 \xc3\xbc")
os.mkdir(odd)
shutil.copy("cube.off", f"{odd}/{odd}.off")
for file, *words in (f"{odd}/{odd}.svg",), (f"{odd}/", "--format", "svg"):
    draw(file, *words, "--title", "{name}", f"{odd}/{odd}.off", LC_ALL="C")
    expect_said(text_of(f"{odd}/{odd}.svg"), "caf\ufffd \ufffd\ufffd ü.off", ">caf\ufffd \ufffd\ufffd ü<")
expect_said(text_of(f"{odd}/contact_sheet.svg"), ">caf\ufffd \ufffd\ufffd ü<")

# --- pens of .5 mm stand out by half their width

DPI = "600"


def expect_extent(picture, millimetres):
    """Width and height of what is black, within a tenth of a millimetre."""
    pixels = run(["convert", picture, "-background", "white", "-alpha", "remove", "-threshold", "50%", "-trim",
                  "-format", "%w %h", "info:"])
    measured = [int(word) * 25.4 / int(DPI) for word in pixels.split()]
    expect(all(abs(size - millimetres) < .1 for size in measured), f"{picture} measures {measured}, not {millimetres}")


draw("kernel.svg", "--scale", "1:1", "--paper", "a2", "--kernel", "3mm", "--smoothing", "1%", "cube.off")
expect_said(text_of("kernel.svg"), "√h 3 mm")
missing = [program for program in ("rsvg-convert", "pdftoppm") if not shutil.which(program)]
for scale, millimetres in (("1:1", 100.5), ("1:2", 50.5)):
    draw("cube.svg", *BARE, "--scale", scale, "cube.off")
    draw("cube.pdf", *BARE, "--scale", scale, "cube.off")
    draw("png.png", *BARE, "--dpi", DPI, "--scale", scale, "cube.off")
    expect_extent("png.png", millimetres)
    if "rsvg-convert" not in missing:
        run(["rsvg-convert", "-d", DPI, "-p", DPI, "-b", "white", "cube.svg", "-o", "svg.png"])
        expect_extent("svg.png", millimetres)
    if "pdftoppm" not in missing:
        run(["pdftoppm", "-r", DPI, "-png", "-singlefile", "cube.pdf", "pdf"])
        expect_extent("pdf.png", millimetres)
if missing:
    skip(f"no {missing[0]}")
