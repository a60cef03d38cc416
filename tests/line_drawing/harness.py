# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of the program of drawings share. A test is called with the program, PROGRAM, and begins in an empty
folder, which goes with it."""

import atexit
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CHECKOUT = HERE.parents[1]
sys.path.insert(0, str(CHECKOUT / "scripts"))
PROGRAM = os.path.realpath(sys.argv[1])
WORK = tempfile.mkdtemp()
os.chdir(WORK)
atexit.register(shutil.rmtree, WORK, ignore_errors=True)


def fail(message):
    sys.exit(f"failed: {message}")


def expect(condition, message):
    if not condition:
        fail(message)


def run(command, code=0, **environment):
    """What it prints, stdout and stderr; it ends with this code, None for any."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, **environment})
    said = os.fsdecode(done.stdout)
    expect(code is None or done.returncode == code, f"{command} ended with {done.returncode} and said: {said}")
    return said


def draw(*words, code=0, **environment):
    return run([PROGRAM, *words], code, **environment)


def refused(sentence, *words):
    """The program ends with an error that holds the sentence and leaves no file."""
    said = draw(*words, code=1)
    expect(sentence in said, f"{words} says: {said}")
    expect(not list(pathlib.Path().glob("plate.*")), f"{words} left a file")


def text_of(file):
    return pathlib.Path(file).read_text(errors="surrogateescape")


VERTICES = ["0 0 0", "100 0 0", "100 100 0", "0 100 0", "0 0 100", "100 0 100", "100 100 100", "0 100 100"]
FACES = ["0 2 1", "0 3 2", "4 5 6", "4 6 7", "0 1 5", "0 5 4", "1 2 6", "1 6 5", "2 3 7", "2 7 6", "3 0 4", "3 4 7"]


def write(file, *lines):
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(file).write_text("".join(f"{line}\n" for line in lines))


def off(file, vertices=VERTICES, faces=FACES):
    write(file, "OFF", f"{len(vertices)} {len(faces)} 0", *vertices, *(f"3 {face}" for face in faces))


def moved(scale=1, x=0, z=0):
    """The cube's vertices, elsewhere."""
    places = (tuple(map(float, vertex.split())) for vertex in VERTICES)
    return [f"{a * scale + x:g} {b * scale:g} {c * scale + z:g}" for a, b, c in places]


def write_cube():
    """A cube of 100 mm of 12 triangles, in three formats."""
    off("cube.off")
    write("cube.obj", *(f"v {vertex}" for vertex in VERTICES),
          *(f"f {' '.join(str(int(word) + 1) for word in face.split())}" for face in FACES))
    write("cube.ply", "ply", "format ascii 1.0", "element vertex 8", *(f"property float {axis}" for axis in "xyz"),
          "element face 12",
          "property list uchar int vertex_indices", "end_header", *VERTICES, *(f"3 {face}" for face in FACES))
