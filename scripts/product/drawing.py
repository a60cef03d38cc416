# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --drawing: measured drawings by our own program, which needs no display."""

import os

from environment.build import build_folder, build_targets
from environment.messages import Failure, run
from product.models import check_mesh, prepare_mesh


def unpack_mesh(name, folder):
    """A folder, or a file, unpacked into the folder if need be."""
    if os.path.isdir(name):
        return name
    if name:
        check_mesh(name)
    folder.mkdir()
    return prepare_mesh(name, folder)


def run_drawing(words, folder):
    """The program's words, but MESH may be missing or gzipped; each is unpacked into a folder of its own, since names
    may be equal."""
    program = build_folder() / "bin/laplacian-lines"
    build_targets("laplacian_lines_drawing", preset="product", extra_packages=())
    options, names = [], []
    while words:
        word = words.pop(0)
        if word in ("-h", "--help", "--version"):
            return run([program, word])
        if word == "--":
            names += words
            break
        if word.startswith("--"):
            taken = 0 if "=" in word else 1
            options += [word, *words[:taken]]
            words = words[taken:]
        else:
            names.append(word)
    if not names:
        raise Failure("--drawing needs the name of a file, FILE.svg, .pdf, .dxf or .png, or of a folder, FOLDER/")
    meshes = [unpack_mesh(name, folder / str(number)) for number, name in enumerate(names[1:] or [""])]
    return run([program, names[0], *options, *meshes])
