# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --picture: a drawing on white paper, also with parameters of the decoration; sheets of meshes, views and kinds
of lines, without the meshes that fail; from all sides, with any axis up, enlarged, without perspective; with lines that
go with the size."""
import gzip

from harness import *
from product.command import parse
from product.meshlab import settings_commands
from product.picture import Pictures, columns_of

os.environ.pop("DISPLAY")  # pictures have displays of their own


def take(file, meshes, *words, settings=(), code=0, said=()):
    """./run --picture FILE MESH...; its drawings are in the folder drawings."""
    options = parse(["--picture", file, *words])
    shutil.rmtree("drawings", ignore_errors=True)
    os.mkdir("drawings")
    pathlib.Path(file).unlink(missing_ok=True)
    pictures = Pictures(STAGE, WORK / "drawings", options, columns_of(BUILD, options.kinds),
                        settings_commands(BUILD, settings))
    ended = said_by(pictures.take, file, meshes)
    expect(ended == code, f"it ended with {ended} instead of {code}: {text_of('log')}")
    for regex in said:
        expect_text("log", regex)


def drawing(row, view, column):
    return f"drawings/drawing_{row}_{view}_{column}.png"


def drawn(file):
    """Width, height, left and top of what is not white."""
    return map(int, re.findall(r"\d+", convert(file, "-alpha", "off", "-fuzz", "20%", "-format", "%@")))


torus()
take("drawing.png", ["torus.ply"], "--size", "500x400")
expect(picture_size("drawing.png") == "500x400", f"the picture is {picture_size('drawing.png')}")
ink = dark_pixels("drawing.png")
expect(1000 < ink < 40000, f"{ink} pixels are dark")
expect(convert("drawing.png", "-format", "%[hex:u.p{2,2}]") == "FFFFFF", "the paper is not white")
take("red.png", ["torus.ply"], "--size", "500x400", settings=["Line Color=red", "Line Width=4"])
expect(red_pixels("red.png") > 0.5 * ink, "the lines are not red and wide")

# a sheet of all that can be drawn, which ends with an error for what cannot
with gzip.open("packed.ply.gz", "wb") as packed:
    packed.write(open("torus.ply", "rb").read())
odd = os.fsdecode(b"caf\xe9 @%w.ply")  # no UTF-8, and what ImageMagick would read a file or put a width for
shutil.copy("torus.ply", odd)
ply("points.ply", ["0 0 0", "1 0 0", "0 1 0"])
ply("mended.ply", ["0 0 0", "1 0 0", "0 1 0", "2 0 0"], ["3 0 1 2", "3 0 1 1"])
lines = text_of("torus.ply").split("end_header\n")[1].splitlines()
ply("far.ply", ["1e30 0 0", *lines[1:1200]],
    [f"3 {i} {i + 1} {i + 2}" for i in range(1000)])
pathlib.Path("broken.ply").write_text("not a mesh\n")
pathlib.Path("crash.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99999999\n")  # has MeshLab read beyond the vertices
pathlib.Path("torus.obj").write_text("".join(
    f"v {' '.join(line)}\n" if len(line) == 3 else f"f {' '.join(str(int(n) + 1) for n in line[1:])}\n"
    for line in map(str.split, lines)))
take("sheet.png", ["packed.ply.gz", "broken.ply", "points.ply", odd, "mended.ply", "far.ply", "torus.obj", "crash.off",
                   "torus.ply"], "--size", "500x400", code=1, said=[
    "broken.ply: MeshLab cannot read it: ", "points.ply: The mesh has no triangle with an area. .* reconstruct one first.$",
    "far.ply: a few vertices lie so far off that nothing could be seen of the rest; delete them$",
    "crash.off: (the reader of .off files crashed MeshLab|MeshLab cannot read it)", r"not drawn: broken\.ply points\.ply far\.ply crash\.off$"])
width = int(picture_size("sheet.png").split("x")[0])
expect(width >= 2 * (500 + 16), f"the sheet is {width} pixels wide")  # two views and the space beside them
expect(os.path.exists(drawing(4, 0, 0)), "a triangle without area is not left out")
for row in (0, 3, 6, 8):
    expect_same_picture("drawing.png", drawing(row, 0, 0))
take("none.png", ["points.ply"], code=1, said=["no picture was written"])

# without perspective, a box, far from the origin, shows the two sizes that the view and the axis that is up leave, as
# large as they fit into 360 pixels: a twentieth of the shorter side is left free
box("box.ply", (50, 20, 0), (4, 3, 2))
for options, faces in (("", {"front": (360, 270), "180,0": (360, 270), "left": (240, 360), "top": (360, 180), "90,90": (180, 360)}),
                       ("--up z --zoom 0.5", {"front": (180, 90), "top": (180, 135)})):
    take("faces.png", ["box.ply"], "--size", "400x400", "--orthographic", *options.split(),
         *(word for view in faces for word in ("--view", view)))
    for number, (view, size) in enumerate(faces.items()):
        width, height, left, top = drawn(drawing(0, number, 0))
        expect(abs(width - size[0]) <= 3 and abs(height - size[1]) <= 3,
               f"{options} {view} shows something of {width}x{height} instead of {size}")
        expect(abs(2 * left + width - 400) <= 4 and abs(2 * top + height - 400) <= 4, f"{view} is not in the middle")
# in perspective there is up to an eighth more air around it
take("face.png", ["box.ply"], "--size", "400x400", "--view", "30,20", "--orthographic")
os.rename("face.png", "parallel.png")
take("face.png", ["box.ply"], "--size", "400x400", "--view", "30,20")
expect_other_picture("face.png", "parallel.png")
width, height, left, top = drawn("face.png")
expect(310 < max(width, height) <= 364 and abs(2 * left + width - 400) <= 4 and abs(2 * top + height - 400) <= 4,
       f"in perspective, the box is {width}x{height} at {left}, {top}")

# a column for each kind of lines; above 900 pixels, lines are as much wider as the shorter side is longer, so that a
# drawing of twice the size has four times the ink
for size in ("900", "1800"):
    take(f"square_{size}.png", ["torus.ply"], "--size", f"{size}x{size}", "--kinds", "usual,apparent_ridges")
    expect_other_picture(drawing(0, 0, 0), drawing(0, 0, 1))
    os.rename(drawing(0, 0, 0), f"usual_{size}.png")
small, large = (float(convert(f"usual_{size}.png", "-alpha", "off", "-colorspace", "gray", "-negate", "-format",
                              "%[fx:mean]")) for size in ("900", "1800"))
expect(0.85 * small < large < 1.15 * small, f"ink of large drawings is {large}, that of small ones {small}")
expect(said_by(columns_of, BUILD, "ridge") == 1, "there are no lines called ridge")
expect_text("log", '^laplacian-lines: there is no picture of lines "ridge". Name some of usual, ')
