# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./run --server runs from MeshLab 2022.02 on, in PyMeshLab's Python: meshlabserver's -i, -s, -o, -m and -l.

    mesh_server.py PLUGIN -i MESH... [-s SCRIPT]... [-o MESH [-m vn|vc|vq|fc|wt...] [-l LAYER|x]]...
"""

import sys
from xml.etree import ElementTree

import pymeshlab

MASKS = {"vn": "save_vertex_normal", "vc": "save_vertex_color", "vq": "save_vertex_quality", "fc": "save_face_color",
         "wt": "save_wedge_texcoord"}


def check(condition, complaint):
    if not condition:
        sys.exit(complaint)


def steps_of(words):
    """Each option with its words."""
    steps = []
    for word in words:
        if word in ("-i", "-s", "-o", "-m", "-l"):
            steps.append((word, []))
        else:
            check(steps and not word.startswith("-"), f"unknown argument {word}; there are {__doc__.splitlines()[2][26:]}")
            steps[-1][1].append(word)
    for option, names in steps:
        check(names, f"{option} needs a word after it")
    return steps


def run_script(meshes, name):
    """PyMeshLab takes what is no script for one without filters."""
    try:
        root = ElementTree.parse(name).getroot()
    except (OSError, ElementTree.ParseError) as error:
        sys.exit(f"{name} cannot be read: {error}")
    check(root.tag == "FilterScript" and root.find("filter") is not None, f"{name} is no filter script")
    check(meshes.mesh_number(), "There is no mesh. Open one with -i.")
    meshes.clear_filter_script()
    meshes.load_filter_script(name)
    meshes.set_verbosity(True)
    meshes.apply_filter_script()
    meshes.set_verbosity(False)


def save(meshes, file, masks=(), layer=("x",)):
    """Layer x is the current one."""
    check(meshes.mesh_number(), "There is no mesh to save.")
    check(all(mask in MASKS for mask in masks), f"-m knows {' '.join(MASKS)}, not all of {' '.join(masks)}")
    current = meshes.current_mesh_id()
    if layer[0] != "x":
        check(layer[0].isdecimal() and meshes.mesh_id_exists(int(layer[0])),
              f"There is no layer {layer[0]} to save; the last one is {meshes.mesh_number() - 1}.")
        meshes.set_current_mesh(int(layer[0]))
    meshes.save_current_mesh(file, **{MASKS[mask]: True for mask in masks})
    meshes.set_current_mesh(current)


def main(plugin, *words):
    pymeshlab.load_plugin(plugin)
    meshes, steps = pymeshlab.MeshSet(), steps_of(words)
    while steps:
        option, names = steps.pop(0)
        check(option not in ("-m", "-l"), f"{option} has to stand after -o MESH")
        if option == "-o":
            choices = dict(steps.pop(0) for _ in range(2) if steps and steps[0][0] in ("-m", "-l"))
            save(meshes, names[0], choices.get("-m", ()), choices.get("-l", ("x",)))
        for name in () if option == "-o" else names:
            meshes.load_new_mesh(name) if option == "-i" else run_script(meshes, name)


try:
    main(*sys.argv[1:])
except pymeshlab.PyMeshLabException as error:
    sys.exit(str(error).strip())
