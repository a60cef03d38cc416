# SPDX-License-Identifier: GPL-3.0-or-later
"""judge.py PROGRAM [--run RUN] [--only REGEX] [--pictures FOLDER]: shapes for which nothing was tuned (parts.py), drawn by
the command with its defaults, and checked by none of the product's code (drawing.py). Prints each case with its figures;
ends with 1 if one is wrong. --run: ./run, for pictures of MeshLab's window. --pictures: PNG files that show errors in
red."""

import argparse
import gzip
import itertools
import multiprocessing.pool
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading

import cv2
import fast_simplification
import numpy as np
import trimesh
from drawing import (OUTLINE_PEN, Drawing, angles, distance_to, drawn, edges, frame, in_obj, in_stl, kept, new_file,
                     outline, run, unlike)
from parts import BOX, BOX_FACES, changed, cone, folded_needle, polyhedra, round_parts, rounded_box, turned, two_boxes, with_middles

FULL_PEN = 42  # mm: drawings that are smaller have finer pens
MODELS = pathlib.Path(__file__).resolve().parents[3] / "shared" / "models"  # beside the checkout, if at all
# Of decimated scans: views, and by the number of triangles the least shares of the scan's ink that is kept, and of the
# ink that is the scan's.
SCANS = {"igea.ply": ("front", {100000: (0.93, 0.91), 50000: (0.91, 0.895), 20000: (0.765, 0.85)}),
         "armadillo.obj": ("180,0", {50000: (0.915, 0.94), 20000: (0.815, 0.93)})}  # of 86,482
DECIMATION = threading.Lock()  # fast_simplification keeps its mesh in globals


# Judges: each yields figures in words, whether they are right, and the picture that shows what is wrong, if any.


def judge_part(mesh, view, is_polyhedron):
    """Size and outline, and edges of polyhedra."""
    drawing = drawn([in_stl(mesh)], "--views", view)
    size = np.ptp(mesh.vertices @ frame(view).T, axis=0)[:2] * drawing.scale
    off = np.abs(drawing.size - size - OUTLINE_PEN).max()
    is_right = off < (0.15 if is_polyhedron else 0.25) and size.max() > FULL_PEN  # round contours are smoothed
    yield f"{size[0]:.1f} x {size[1]:.1f} mm, off by {off:.2f}", is_right, None
    thinnest, share, picture = outline(drawing, mesh, view)
    yield f"outline: at least {thinnest:.2f} mm of ink, {share:.4f} whole", share == 1, picture
    if is_polyhedron:
        found, stray, picture = edges(drawing, mesh, view)
        is_right = found > 0.995 and stray < 0.002
        yield f"edges: {found:.4f} drawn, {stray:.4f} of the ink elsewhere", is_right, picture


def judge_likeness(one, other, share=0.01, flip=()):
    """Of two drawings, given as words for the command."""
    figure, picture = unlike(drawn(*one), drawn(*other), flip)
    yield f"{100 * figure:.2f} % of the ink is not in both", figure <= share, picture


def judge_flatness(file, mesh):
    _, stray, picture = edges(drawn([file]), mesh, "front", has_edges=False)
    yield f"{stray:.4f} of the ink is in a flat face", stray < 0.002, picture


def judge_decimation(model, view, least):
    """Of one scan, see SCANS."""
    mesh = scan_of(model)
    whole = drawn([in_obj(mesh.vertices, mesh.faces)], "--views", view)
    for count, shares in least.items():
        with DECIMATION:
            decimated = fast_simplification.simplify(mesh.vertices.astype(np.float32), mesh.faces.astype(np.int32),
                                                     target_count=count)
        *found, picture = kept(whole, drawn([in_obj(*decimated)], "--views", view), mesh, view)
        right = all(np.array(found) > shares)
        yield f"{count}: {found[0]:.3f} of the scan's ink kept, {found[1]:.3f} of the ink is its", right, picture


def scan_of(model):
    with gzip.open(model) as file:
        mesh = trimesh.load(file, file_type=pathlib.Path(model.stem).suffix[1:], process=False)
    if isinstance(mesh, trimesh.PointCloud):  # trimesh leaves strips, which -1 ends, as they are
        strips = np.concatenate(mesh.metadata["_ply_raw"]["tristrips"]["data"]["vertex_indices"]["f1"])
        faces = []
        for strip in np.split(strips, np.flatnonzero(strips < 0)):
            strip = strip[strip >= 0]
            faces.append(np.stack([strip[:-2], strip[1:-1], strip[2:]], 1))
            faces[-1][1::2] = faces[-1][1::2, ::-1]
        mesh = trimesh.Trimesh(mesh.vertices, np.concatenate(faces), process=False)
    mesh.update_faces(mesh.nondegenerate_faces())
    return mesh.apply_scale(100 / mesh.extents.max())  # mm; fast_simplification's tolerances are absolute


def judge_window(window, meshes):
    """Whether a sheet of two has as much ink for each in both orders."""
    inks = []
    for order in (meshes, meshes[::-1]):
        run([window, "--picture", sheet := new_file("png"), "--size", "600x450", "--view", "30,35", *order])
        dark = cv2.imread(str(sheet), cv2.IMREAD_GRAYSCALE) < 128
        inks.append([half.sum() for half in np.array_split(dark, 2, axis=1)])
    inks = np.array([inks[0], inks[1][::-1]])
    figure = np.ptp(inks, axis=0).max() / max(inks.min(), 1)
    yield f"{100 * figure:.2f} % more ink or less in another order", inks.min() > 0 and figure < 0.02, None


# Cases: a name, the judge, and what it judges.


def window_cases(window):
    boxes = [in_obj(corners * (40, 30, 20), BOX_FACES) for corners in (BOX, 2 * BOX, BOX[::-1])]
    yield "window: boxes", judge_window, dict(window=window, meshes=boxes[:2])
    yield "window: box and cylinder", judge_window, dict(window=window, meshes=[boxes[2], in_stl(cone(40, 15, 15, 32))])


def changes_of(name, mesh, view):
    """Drawings of a part do not depend on where it is, on its unit, or on which way its faces are turned."""
    plain = [in_stl(mesh)], "--views", view
    azimuth, elevation = angles(view)
    mirrored = [in_stl(changed(mesh, (-1, 1, 1), turns=True))], "--views", f"{0 - azimuth:g},{elevation:g}"
    yield f"mirrored {name}", judge_likeness, dict(one=plain, other=mirrored, flip=1)
    for change, file, *words in (("inside out:", in_stl(changed(mesh, 1, turns=True))),
                                 ("in metres:", in_stl(changed(mesh, 1e-3)), "--unit", "m"),
                                 ("moved to 4e5, 5.8e6:", in_obj(mesh.vertices + [4e5, 5.8e6, 30], mesh.faces))):
        yield f"{change} {name}", judge_likeness, dict(one=plain, other=([file], *words, "--views", view))


def twins():
    """Shapes that are the same to the eye."""
    for size, flip in itertools.product(((140, 70, 8), (140, 8, 70)), (0, 1)):
        case = [in_stl(rounded_box(size, 1, 6))],
        yield f"symmetry of a case of {size}, {flip}", judge_likeness, dict(one=case, other=case, flip=flip)
    for size, cut in (((40, 30, 20), [(7, 6)]), ((60, 8, 30), [(6, 5), (7, 6)]), ((25, 30, 40), [(6, 2), (5, 6)])):
        one, other = (([in_obj(*with_middles(BOX * size, cut, both))], "--views", "30,30") for both in (False, True))
        yield f"T-junctions {size}", judge_likeness, dict(one=one, other=other)
    for size, view in (((40, 30, 20), "30,30"), ((60, 8, 30), "front"), ((25, 30, 40), "-40,25")):
        one, other = (([in_obj(*two_boxes(size, gap))], "--views", view) for gap in (0, 1e-5))
        yield f"flush boxes {size}", judge_likeness, dict(one=one, other=other)


def needles():
    for side, at, width in ((100, 0.5, 0.001), (60, 0.3, 0.0005), (150, 0.62, 0.002)):
        mesh = folded_needle(side, at, width)
        yield f"folded needle, {side}", judge_flatness, dict(file=in_obj(mesh.vertices, mesh.faces), mesh=mesh)
        mesh = turned(mesh, side)
        yield f"folded needle, {side}, turned", judge_flatness, dict(file=in_stl(mesh), mesh=mesh)


def scans():
    for name, (view, least) in SCANS.items():
        if (model := MODELS / f"{name}.gz").exists():
            yield f"{name} of fewer triangles", judge_decimation, dict(model=model, view=view, least=least)
        else:
            print(f"skipped: there is no {model}")


def cases(window):
    if window:
        yield from window_cases(window)
    parts = {name: (mesh, view, True) for name, mesh, view in polyhedra()}
    parts |= {name: (mesh, view, False) for name, mesh, view in round_parts()}
    for name, (mesh, view, is_polyhedron) in parts.items():
        yield name, judge_part, dict(mesh=mesh, view=view, is_polyhedron=is_polyhedron)
    for name, (mesh, view, _) in parts.items():
        if re.match("drilled plate|drilled block|torus|bumps$|vase|hull of 9 points|phone", name):
            yield from changes_of(name, mesh, view)
    yield from itertools.chain(twins(), needles(), scans())
    files = [in_stl(parts["drilled block"][0]), in_stl(changed(parts["torus"][0], 0.5))]
    one, other = ((order, "--views", "30,30") for order in (files, files[::-1]))
    yield "order of files", judge_likeness, dict(one=one, other=other, share=0)


def judged(name, judge, words, pictures):
    """Rows of the table: the name, a figure, and whether it is right."""
    rows = []
    try:
        for number, (figure, is_right, picture) in enumerate(judge(**words)):
            rows.append((name, figure, is_right))
            if pictures and picture and picture[1].any():
                save(pictures / f"{name} {number}.png", *picture)
    except Exception as reason:  # whatever a wrong drawing leads to; the other cases go on
        rows.append((name, f"{type(reason).__name__}: {reason}", False))
    return rows


def save(file, ink, wrong):
    picture = np.where(ink[..., None], np.uint8([99] * 3), np.uint8([255] * 3))
    picture[distance_to(wrong) < 5] = 0, 0, 255
    cv2.imwrite(str(file), picture[::3, ::3])


def main():
    parser = argparse.ArgumentParser()
    for name, words in (("program", {"type": os.path.realpath}), ("--run", {}), ("--only", {"default": ""}),
                        ("--pictures", {"type": pathlib.Path})):
        parser.add_argument(name, **words)
    options = parser.parse_args()
    cv2.setNumThreads(1)
    with tempfile.TemporaryDirectory() as folder, multiprocessing.pool.ThreadPool(os.cpu_count()) as pool:
        Drawing.program, Drawing.folder = options.program, pathlib.Path(folder)
        chosen = [case for case in cases(options.run) if re.search(options.only, case[0])]
        if not chosen:
            sys.exit(f"no case has a name like {options.only}")
        rows = sum(pool.map(lambda case: judged(*case, options.pictures), chosen, chunksize=1), [])
    for name, figure, right in rows:
        print(f"{name:46} {figure:62} {'' if right else 'WRONG'}".rstrip())
    wrong = sum(not right for *_, right in rows)
    sys.exit(f"{wrong} of {len(rows)} figures are wrong" if wrong else 0)


if __name__ == "__main__":
    main()
