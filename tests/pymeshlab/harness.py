# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests in PyMeshLab share."""

import os
import pathlib

import laplacian_lines
import pymeshlab

BUILD = pathlib.Path(os.environ["LAPLACIAN_LINES_BUILD"])
MESH = BUILD / "Testing/reference/torus.ply"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "docs/examples"

# PyMeshLab 2025.7 crashes when a mesh is loaded after a set in which a filter has failed is gone: none goes.
_all_sets = []


def meshes(path=MESH):
    """A MeshSet with the mesh of this file."""
    result = pymeshlab.MeshSet()
    _all_sets.append(result)
    if path:
        result.load_new_mesh(str(path))
    return result


def work_folder(name):
    folder = BUILD / "Testing/pymeshlab" / name
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def run_script(example, change=lambda text: text):
    """The meshes after the example script, or what it is changed to."""
    script = work_folder("scripts") / example
    script.write_text(change((EXAMPLES / example).read_text()))
    ms = meshes()
    ms.load_filter_script(str(script))
    ms.apply_filter_script()
    return ms


def expect_error(words, function, *arguments, **keywords):
    """Fails unless the call raises one of PyMeshLab's exceptions that says `words`."""
    try:
        function(*arguments, **keywords)
    except (pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException) as error:
        assert words in str(error), f"the exception says: {error}"
    else:
        raise AssertionError(f"nothing was raised; expected: {words}")


laplacian_lines.load()
