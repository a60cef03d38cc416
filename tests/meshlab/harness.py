# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests in MeshLab share. A test imports all of it, and then is in an empty folder of its own, which is kept
afterwards for a look, with a display and a home folder. The first thing that is not as expected ends it and shows the
log."""

import atexit
import contextlib
import filecmp
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(CHECKOUT / "scripts"))

from environment.files import cache_folder
from environment.messages import Failure, exit_code, say, skip
from environment.packages import meshlab_version
from product.display import SETTINGS, display, private_home
from product.models import bumpy_torus

EXAMPLES = CHECKOUT / "docs/examples"
BUILD = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
STAGE = BUILD / "stage"
TEST = os.path.realpath(sys.argv[0])
WORK = BUILD / "Testing/meshlab" / pathlib.Path(TEST).stem
SECONDS = float(os.environ.get("DRIVE_SECONDS", 200))  # a hung MeshLab, before ctest's own limit, so that its log is shown


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def show_failure(*error):
    if (WORK / "log").is_file():
        print(f"--- the end of {WORK}/log", *text_of(WORK / "log").splitlines()[-60:], sep="\n")
    sys.__excepthook__(*error)


def begin_test():
    sys.excepthook = show_failure
    if os.environ.get("TEST_GOES_ON"):  # in a copy of the system
        os.chdir(WORK)
        return
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    os.chdir(WORK)
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: sys.exit(143))
    shown = contextlib.ExitStack()
    atexit.register(shown.close)
    shown.enter_context(display(1700, 1000))
    os.environ["LAPLACIAN_LINES_CACHE"] = str(cache_folder())  # the user's: models are fetched once
    environment = private_home(WORK / "home")
    os.environ.clear()
    os.environ.update(environment)
    os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"  # the same pixels on every machine, whatever the graphics card
    # MeshLab keeps each setting as a small XML text under its own name: a white background
    color = " ".join(f'{c}=\\"255\\"' for c in "rgba")
    names = (f"MeshLab::Appearance::background{place}Color" for place in ("Bot", "Top"))
    (WORK / "home/.config/VCG/MeshLab_64bit_fp.conf").write_text(SETTINGS + "".join(
        f'{name.replace(":", "%3A")}="<Param type=\\"RichColor\\" name=\\"{name}\\" {color} description=\\"\\" '
        'tooltip=\\"\\"/>"\n' for name in names))


# --- MeshLab and its driver


def run_in_work(command, **environment):
    with open("log", "wb") as log:
        try:
            return exit_code(subprocess.run(command, cwd=WORK, env={**os.environ, **environment}, stdout=log, stderr=log,
                                            timeout=SECONDS).returncode)
        except subprocess.TimeoutExpired:
            return 124


def run_driver(script, stage=None):
    """The exit code of MeshLab driven by the script."""
    pathlib.Path("script").write_text(script.rstrip("\n") + "\nquit\n")
    return run_in_work([(stage or STAGE) / "bin/meshlab"], LAPLACIAN_LINES_DRIVER=str(WORK / "script"))


def drive(script, stage=None):
    code = run_driver(script, stage)
    expect(code == 0, f"MeshLab ended with {code}")


def drive_to_failure(regex, script, stage=None):
    """The driver ends MeshLab with an error whose text matches."""
    code = run_driver(script, stage)
    expect(code == 3, f"MeshLab ended with {code} instead of the driver's 3")
    expect_text("log", f"meshlab_driver: error: .*{regex}")


# Nothing but meshes and the current layer's lines in the view, live, so that it does not matter when a picture is taken.
SHOW_LINES = """size 500x400
check Show Info Panel off
check Show Trackball off
draw-lines
setdeco Line Color = #ff0000
setdeco At Rest = 1
"""


# --- meshlabserver


def serve(*words, **environment):
    """The exit code of meshlabserver, or of what ./run --server runs in its place."""
    server = shlex.split(os.environ.get("MESH_SERVER", "")) or [STAGE / "bin/meshlabserver"]
    return run_in_work([*server, *words], **environment)


def filter_script(example, settings, file="script.mlx"):
    """Writes the example with other values of its parameters."""
    text = (EXAMPLES / example).read_text()
    for key, value in settings.items():
        if isinstance(value, tuple):  # of a point
            pattern, value = rf'(name="{key}" [^>]*) x="[^"]*" y="[^"]*" z="[^"]*"', ' x="{}" y="{}" z="{}"'.format(*value)
        else:
            pattern, value = rf'(name="{key}" [^>]* value=")[^"]*', f"{value}"
        text, count = re.subn(pattern, lambda m, value=value: m[1] + value, text)
        expect(count, f"the example has no parameter {key}")
    pathlib.Path(file).write_text(text)


def accept(file, example, mesh="torus.ply", **settings):
    """The mesh after the example with these settings."""
    filter_script(example, settings)
    pathlib.Path(file).unlink(missing_ok=True)
    code = serve("-i", mesh, "-s", "script.mlx", "-o", file)
    expect(code == 0 and is_file(file), f"the script with {settings} ended with {code}")


def refuse(reason, example, mesh="torus.ply", **settings):
    """The example with these settings; no file is left behind, which would hold the mesh without result."""
    filter_script(example, settings)
    pathlib.Path("none.ply").unlink(missing_ok=True)
    expect(serve("-i", mesh, "-s", "script.mlx", "-o", "none.ply"), f"the script with {settings} was accepted")
    expect_text("log", reason)
    expect(not os.path.exists("none.ply"), f"the script with {settings} wrote a mesh")


# --- ./run


def said_by(function, *words, **options):
    """The exit code of a script that does no more than this; what it says is in "log"."""
    sys.stderr.flush()
    kept = os.dup(2)
    with open("log", "wb") as log:
        os.dup2(log.fileno(), 2)
    try:
        function(*words, **options)
        return 0
    except Failure as failure:
        say(failure)
        return 1
    finally:
        os.dup2(kept, 2)
        os.close(kept)


# --- files


def output(*command, **options):
    options = {"errors": "surrogateescape", **options}
    return subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True, **options).stdout


def text_of(file):
    return pathlib.Path(file).read_text(errors="surrogateescape")


def is_file(file):
    return os.path.isfile(file) and os.path.getsize(file) > 0


def same_file(a, b):
    return filecmp.cmp(a, b, shallow=False)


def expect_text(file, regex):
    """In one of its lines."""
    expect(re.search(regex, text_of(file), re.M), f"{file} has nothing that matches: {regex}")


def expect_no_text(file, regex):
    expect(not re.search(regex, text_of(file), re.M), f"{file} has something that matches: {regex}")


# --- pictures


def convert(*words):
    """What ImageMagick prints of a picture."""
    return output("convert", *words, "info:").strip()


def pixels(*words):
    """How many pixels are white after these operations; what is left in between counts in parts."""
    return int(convert(*words, "-format", "%[fx:round(mean*w*h)]"))


def red_pixels(file):
    return pixels(file, "-alpha", "off", "-fuzz", "35%", "-fill", "black", "+opaque", "red", "-fill", "white",
                  "-opaque", "red", "-colorspace", "gray")


def dark_pixels(file):
    return pixels(file, "-alpha", "off", "-colorspace", "gray", "-threshold", "50%", "-negate")


def picture_size(file):
    return convert(file, "-format", "%wx%h")


def differing_pixels(a, b):
    return pixels(a, b, "-alpha", "off", "-compose", "Difference", "-composite", "-fill", "white", "+opaque", "black",
                  "-colorspace", "gray")


def expect_same_picture(a, b, most=0):
    differing = differing_pixels(a, b)
    expect(differing <= most, f"{differing} pixels differ between {a} and {b}, more than {most}")


def expect_other_picture(a, b, least=100):
    differing = differing_pixels(a, b)
    expect(differing >= least, f"only {differing} pixels differ between {a} and {b}")


# --- meshes


def write_mesh(file, rings, sides):
    pathlib.Path(file).write_text(bumpy_torus(rings, sides))


def small_torus(file="torus.ply"):
    write_mesh(file, 40, 30)


def torus(file="torus.ply"):
    """With lines all over it."""
    write_mesh(file, 160, 80)


def ply(file, vertices, faces=()):
    """An ASCII file of these lines."""
    header = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}", *(f"property float {c}" for c in "xyz"),
              f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    pathlib.Path(file).write_text("\n".join([*header, *vertices, *faces]) + "\n")


def box(file, corner, size):
    """From this corner on, of quadrangles."""
    ply(file, [" ".join(f"{a + s * (i >> axis & 1)}" for axis, (a, s) in enumerate(zip(corner, size))) for i in range(8)],
        ["4 0 2 3 1", "4 4 5 7 6", "4 0 1 5 4", "4 2 6 7 3", "4 0 4 6 2", "4 1 3 7 5"])


begin_test()
