# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --picture --kinds: a column for each kind of lines and a row for each mesh, another one with noise; edges of
pictures beside them, where scikit-image can be had; a mesh that fails does not stop the others."""
from harness import *
from product.picture import columns_of, image_python

begin_pictures()


def take(*words, meshes=("torus.ply",), code=0):
    ended = said_by(take_pictures, "sheet.png", meshes, "--size", "300x200", *words)
    expect(ended == code, f"it ended with {ended} instead of {code}")


def drawn(row, column):
    return f"drawings/drawing_{row}_0_{column}.png"


torus()
pathlib.Path("broken.ply").write_text("not a mesh\n")
take("--kinds", "usual")
shutil.copy("sheet.png", "plain.png")
take()
expect(differing_pixels("plain.png", "sheet.png") > 50, "the kernel does not go with the picture's size")

kinds = "usual,apparent_ridges,laplacian_lines,ridges+valleys,suggestive_contours_and_highlights,contours"
take("--kinds", kinds, "--noise", "0.2", meshes=["torus.ply", "broken.ply"], code=1)
expect_text("log", "broken.ply: MeshLab cannot read it")
width, height = map(int, picture_size("sheet.png").split("x"))
expect(width == 6 * 316 and 2 * 216 < height < 3 * 216, f"the sheet is {width}x{height}")
expect_same_picture("plain.png", drawn(0, 0), 0)
for a in range(6):
    expect(differing_pixels(drawn(0, a), drawn(1, a)) > 100, f"noise does not change column {a}")
    for b in range(a + 1, 6):
        expect(differing_pixels(drawn(0, a), drawn(0, b)) > 50, f"the columns {a} and {b} are the same")
# highlights are white on gray, and what follows is on white again
expect(convert(drawn(0, 4), "-format", "%[hex:u.p{9,9}]").startswith("A8A8A8"),
       "the paper under highlights is not gray")
expect_between(20, pixels(drawn(0, 4), "-shave", "12x12", "-threshold", "80%"), 2000, "pixels of highlights")
expect(convert(drawn(0, 5), "-format", "%[hex:u.p{9,9}]").startswith("FFFFFF"),
       "the paper after highlights is not white")

# the same noise again
shutil.copy(drawn(1, 0), "noisy.png")
take("--kinds", "usual", "--noise", "0.2")
expect_same_picture("noisy.png", drawn(1, 0), 0)

expect(said_by(columns_of, BUILD, "ridge") == 1, "there are no lines called ridge")
expect_text("log", '^laplacian-lines: --kinds: there are no lines "ridge". Name some of usual, ')

if said_by(image_python) == 0:
    take("--kinds", "log,canny,contours")
    for column in (0, 1):
        ink = float(convert(drawn(0, column), "-colorspace", "gray", "-negate", "-format", "%[fx:mean]"))
        expect_between(0.005, ink, 0.2, f"ink of the edges of column {column}")
    expect(differing_pixels(drawn(0, 0), drawn(0, 1)) > 50, "both detectors give the same edges")
else:
    print(f"without edges of pictures: {text_of('log')}")
