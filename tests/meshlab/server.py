# SPDX-License-Identifier: GPL-3.0-or-later
"""The program that stands in for meshlabserver from MeshLab 2022.02 on: needs no display, gives the core's results, and
ends with a sentence and an exit code when something is wrong."""
import resource

from harness import *

os.environ.pop("DISPLAY")
EXAMPLE = EXAMPLES / "laplacian_lines.mlx"


def expect_success(*words):
    code = serve(*words)
    expect(code == 0, f"{words} ended with {code}")


def expect_refusal(code, reason, *words):
    """It ends with this code and reason, and writes no mesh."""
    pathlib.Path("none.ply").unlink(missing_ok=True)
    ended = serve(*words)
    expect(ended == code, f"{words} ended with {ended} instead of {code}")
    expect_text("log", reason)
    expect(not os.path.exists("none.ply"), f"{words} wrote a mesh")


reference_mesh("torus")
expect_success("-i", "torus.ply", "-s", EXAMPLE, "-o", "out.ply", "-m", "va")
expect_reference_attributes("out.ply")

for pattern, text, reason in (
        ('Compute Laplacian Lines"', 'Compute Laplacian"',
         r'There is no filter "Compute Laplacian"\. Similar ones: Compute Laplacian Lines'),
        ('name="accuracy"', 'name="acuracy"', r"There is no parameter acuracy\. There are: kernel_size, "),
        ('value="0.001"', 'value="much"', 'Parameter accuracy: "much" is not a number'),
        ("RichAbsPerc", "RichLength", "Parameter kernel_size: the type RichLength cannot be read"),
        ('RichFloat" value="0.001"', 'RichBool" value="true"',
         "Parameter accuracy has the type RichFloat, not RichBool"),
        (r'(name="kernel_mode".* value=")0', r"\g<1>7",
         r'"Kernel" is 7\. It has to be one of 0 \(Uniform\), 1 \(Adaptive\)'),
        ("</FilterScript>", "", "is not XML: line [0-9]+"),
        ("FilterScript>", "Filters>", "is not a MeshLab filter script: its root is <Filters>"),
        ("(</?)filter(?= |>)", r"\1filters", "has no filter")):
    changed, count = re.subn(pattern, text, EXAMPLE.read_text())
    expect(count, f"the example has nothing that matches {pattern}")
    pathlib.Path("changed.mlx").write_text(changed)
    expect_refusal(1, reason, "-i", "torus.ply", "-s", "changed.mlx", "-o", "none.ply")

pathlib.Path("broken.ply").write_text("ply\nformat ascii 1.0\nelement vertex 5\n")
for code, reason, words in (
        (1, r"missing\.ply cannot be read: No such file", "-i missing.ply -o none.ply"),
        (1, r"broken\.ply", "-i broken.ply -o none.ply"),
        (1, r"missing\.mlx cannot be read: No such file", "-i torus.ply -s missing.mlx -o none.ply"),
        (1, r"There is no mesh to save", "-o none.ply"),
        (1, r"no_folder/none\.ply cannot be written: No such file", "-i torus.ply -o no_folder/none.ply"),
        (1, r"none\.xyzw", "-i torus.ply -o none.xyzw"),
        (1, r"There is no layer 2 to save .* the last one is 0", "-i torus.ply -o none.ply -l 2"),
        (1, r"other\.so does not exist", "--plugin other.so -i torus.ply -o none.ply"),
        (2, "unknown argument -q", "-q"),
        (2, "-i needs the name of a file", "-i -o none.ply"),
        (2, "-m does not know vv", "-i torus.ply -o none.ply -m vn vv"),
        (2, "-l after -o needs a layer", "-i torus.ply -o none.ply -l first")):
    expect_refusal(code, reason, *words.split())
expect_refusal(1, r"There is no mesh\. Open one with -i", "-s", EXAMPLE, "-o", "none.ply")

# layers, masks, the log, projects
pathlib.Path("sphere.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
expect_success(*("-l said.txt -i torus.ply sphere.obj -o current.ply -m vn vc sa -o first.ply -l 0 -o last.stl -l x "
                 "-w both.mlp").split())
for regex in ("^element vertex 4$", "^format ascii", "^property float nx$"):
    expect_text("current.ply", regex)
expect_text("first.ply", "^element vertex 3200$")
expect_no_text("first.ply", "property float nx")
expect_text("said.txt", r"^opened .*torus\.ply: 3200 vertices, 6400 faces$")
expect_success(*"-p both.mlp -o again.ply -l 0".split())
expect(same_file("again.ply", "first.ply"), "the project's mesh is another one")
expect(is_file("sphere_out.obj") and is_file("torus_out.ply"), "the project's meshes are not where they should be")

expect_success("-d", "filters.txt")
expect_text("filters.txt", "^Compute Laplacian Lines$")
expect_text("filters.txt", r"^    gradient_radius \(RichFloat\): Gradient Radius$")


def serve_within(megabytes, *words):
    """With so much address space."""
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, most))
    try:
        return serve(*words)
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (most, most))


# What a small mesh needs, within 8 MB, is not enough for a large one: it says so and writes nothing.
least, enough = 0, 8192
while enough - least > 8:
    middle = (least + enough) // 2
    if serve_within(middle, "-i", "torus.ply", "-s", EXAMPLE, "-o", "small.ply") == 0:
        enough = middle
    else:
        least = middle
write_mesh("large.ply", 800, 500)
for more in (8, 32, 64, 96):
    code = serve_within(enough + more, "-i", "large.ply", "-s", EXAMPLE, "-o", "none.ply")
    expect(code == 1, f"{more} MB more than a small mesh needs: it ended with {code}")
    expect_text("log", "(?i)not enough memory")
    expect(not os.path.exists("none.ply"), f"{more} MB more than a small mesh needs: it wrote a mesh")
