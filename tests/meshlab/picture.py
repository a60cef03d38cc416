# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --picture: a drawing on white paper, also with parameters of the decoration; sheets of views and meshes; from
all sides, with any axis up, enlarged, without perspective; with lines that go with the size."""
import gzip

from harness import *

begin_pictures()


def take(file, mesh, *words, settings=()):
    take_pictures(file, [mesh], "--size", "500x400", *words, settings=settings_commands(BUILD, settings))


def dark_pixels(file):
    return pixels(file, "-alpha", "off", "-colorspace", "gray", "-threshold", "50%", "-negate")


def drawn(file):
    """Width, height, left and top of what is not white."""
    return map(int, re.findall(r"\d+", convert(file, "-alpha", "off", "-fuzz", "20%", "-format", "%@")))


torus()
take("drawing.png", "torus.ply")
expect_picture("drawing.png", "500x400")
ink = dark_pixels("drawing.png")
expect_between(1000, ink, 40000, "dark pixels")
expect(convert("drawing.png", "-format", "%[hex:u.p{2,2}]") == "FFFFFF", "the paper is not white")
take("with_settings.png", "torus.ply", settings=["Drawing Style=Publication"])
expect_same_picture("drawing.png", "with_settings.png", 0)
take("with_settings.png", "torus.ply", settings=["Line Color=red", "Contour Color=red", "Line Width=4"])
expect(red_pixels("with_settings.png") > 1.5 * ink, "the lines are not red and wide")

with gzip.open("torus.ply.gz", "wb") as packed:
    packed.write(open("torus.ply", "rb").read())
take("sheet.png", "torus.ply.gz", "--view", "30,15", "--view", "-60,0")
width, height = map(int, picture_size("sheet.png").split("x"))
expect(width == 2 * 516 and height > 416, f"the sheet is {width}x{height}")
expect(2 * ink < 3 * dark_pixels("sheet.png"), "the sheet holds less than two drawings")

# names that are no UTF-8, in any locale
odd = os.fsdecode(b"caf\xe9 @%w.")
shutil.copy("torus.ply", f"{odd}ply")
for locale in ("C", "C.UTF-8"):
    os.environ["LC_ALL"] = locale
    take(f"{odd}png", f"{odd}ply", "--view", "front", "--view", "top")
    expect_same_picture("drawing.png", "drawings/drawing_0_0_0.png", 0)
    os.rename(f"{odd}png", f"odd_{locale}.png")
expect_same_picture("odd_C.png", "odd_C.UTF-8.png", 0)

# without perspective, a box, far from the origin, shows the two sizes that the view and the axis that is up leave, as
# large as they fit into 360 pixels: a twentieth of the shorter side is left free
ply("box.ply", corners(4, 3, 2, left=50, bottom=20), CUBE_FACES)
for options, faces in (
        ("", "front 360x270 180,0 360x270 left 240x360 top 360x180 bottom 360x180 90,90 180x360"),
        ("--up z", "front 360x180 top 360x270"), ("--up x", "back 270x360 right 180x360"),
        ("--zoom 0.5", "front 180x135 90,90 90x180")):
    views, sizes = faces.split()[::2], faces.split()[1::2]
    take("faces.png", "box.ply", "--size", "400x400", "--orthographic", *options.split(),
         *(w for view in views for w in ("--view", view)))
    for number, size in enumerate(sizes):  # of the drawings, which a sheet leaves in its folder
        file = f"drawings/drawing_0_{number}_0.png"
        width, height, left, top = drawn(file)
        expected = [int(word) for word in size.split("x")]
        expect(abs(width - expected[0]) <= 3 and abs(height - expected[1]) <= 3,
               f"{options} {views[number]} shows something of {width}x{height} instead of {size}")
        expect(abs(2 * left + width - 400) <= 4 and abs(2 * top + height - 400) <= 4, f"{file} is not in the middle")
# in perspective, the front of the box hides the rest: it has its proportions, and there is more air around it
take("face.png", "box.ply", "--size", "400x400", "--view", "back", "--zoom", "0.5")
width, height, *_ = drawn("face.png")
expect(160 < width <= 184 and abs(4 * height - 3 * width) < 16, f"in perspective, the back is {width}x{height}")

# above 900 pixels, lines are as much wider as the shorter side is longer, so that a drawing of twice the size has four
# times the ink
for size in ("900", "1800"):
    take(f"square_{size}.png", "torus.ply", "--size", f"{size}x{size}")
small, large = (float(convert(f"square_{size}.png", "-alpha", "off", "-colorspace", "gray", "-negate", "-format",
                              "%[fx:mean]"))
                for size in ("900", "1800"))
expect_between(0.85 * small, large, 1.15 * small, "large drawings have lines of other proportions")
