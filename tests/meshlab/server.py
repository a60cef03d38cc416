# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./run --server runs from MeshLab 2022.02 on: needs no display, and ends with a sentence, an exit code and no mesh
when something is wrong."""
from harness import *

os.environ.pop("DISPLAY")
EXAMPLE = str(EXAMPLES / "laplacian_lines.mlx")


def expect_success(*words):
    code = serve(*words)
    expect(code == 0, f"{words} ended with {code}")


small_torus()
text = pathlib.Path(EXAMPLE).read_text()
for name, old, new in (("other", 'Compute Laplacian Lines"', 'Compute Laplacian"'), ("cut", "</FilterScript>", ""),
                       ("root", "FilterScript>", "Filters>"), ("empty", text[text.index(" <filter"):], "</FilterScript>\n"),
                       ("wrong", '(name="kernel_size".* )value="0"', r'\1value="-1"')):
    changed, count = re.subn(old if name == "wrong" else re.escape(old), new, text)
    expect(count, f"the example has no {old}")
    pathlib.Path(f"{name}.mlx").write_text(changed)
pathlib.Path("broken.ply").write_text("ply\nformat ascii 1.0\nelement vertex 5\n")
for reason, words in (
        (r"missing\.ply", "-i missing.ply -o none.ply"),
        (r"broken\.ply", "-i broken.ply -o none.ply"),
        (r"missing\.mlx cannot be read: .*No such file", "-i torus.ply -s missing.mlx -o none.ply"),
        (r"cut\.mlx cannot be read: no element", "-i torus.ply -s cut.mlx -o none.ply"),
        (r"root\.mlx is no filter script", "-i torus.ply -s root.mlx -o none.ply"),
        (r"empty\.mlx is no filter script", "-i torus.ply -s empty.mlx -o none.ply"),
        ("Something really bad happened", "-i torus.ply -s other.mlx -o none.ply"),
        (r'"Kernel Size" is -1\. It has to be at least 0', "-i torus.ply -s wrong.mlx -o none.ply"),
        (r"There is no mesh\. Open one with -i", f"-s {EXAMPLE} -o none.ply"),
        (r"There is no mesh to save", "-o none.ply"),
        (r"no_folder/none\.ply", "-i torus.ply -o no_folder/none.ply"),
        (r"xyzw", "-i torus.ply -o none.xyzw"),
        (r"There is no layer 2 to save; the last one is 0", "-i torus.ply -o none.ply -l 2"),
        ("unknown argument -q", "-q"),
        ("-i needs a word after it", "-i -o none.ply"),
        ("-m knows vn .*, not all of vn vv", "-i torus.ply -o none.ply -m vn vv"),
        ("-l has to stand after -o MESH", "-l 0 -i torus.ply")):
    ended = serve(*words.split())
    expect(ended == 1, f"{words} ended with {ended}")
    expect_text("log", reason)
    expect(not os.path.exists("none.ply"), f"{words} wrote a mesh")

# layers and masks
pathlib.Path("pyramid.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
expect_success(*"-i torus.ply pyramid.obj -o current.ply -m vn vc -l x -o first.ply -l 0 -o last.stl".split())
expect_text("current.ply", "^element vertex 4$")
expect_text("current.ply", "^property [a-z]+ nx$")
expect_text("first.ply", "^element vertex 1200$")
expect_no_text("first.ply", " nx$")
expect(is_file("last.stl"), "the last layer was not written")
