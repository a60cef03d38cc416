# SPDX-License-Identifier: GPL-3.0-or-later
"""judge.py PROGRAM [--run RUN] [--only REGEX] [--pictures FOLDER]: shapes for which nothing was tuned, drawn by the command
with its defaults, and checked by rsvg-convert, OpenCV and trimesh, by none of the product's code. Prints each case with its
figures; ends with 1 if one is wrong. --run: ./run, for pictures of MeshLab's window. --pictures: PNG files that show errors
in red."""

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
import xml.etree.ElementTree

import cv2
import fast_simplification
import numpy as np
import trimesh
from manifold3d import CrossSection, Manifold

PIXELS = 20  # a millimetre
OUTLINE, THINNEST, INNER_PEN, FULL_PEN = 0.5, 0.35, 0.25, 42  # mm; drawings smaller than the last have finer pens
CORNERS = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])  # of a box
SIDES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
L = [(0, 0), (60, 0), (60, 12), (15, 12), (15, 45), (0, 45)]  # outlines of plates
COMB = [(0, 0), (70, 0), *itertools.chain(*(((70 - 5 * i, y), (65 - 5 * i, y)) for i, y in enumerate(7 * (20, 4))))]
STAIRS = [(0, 0), (40, 0), *itertools.chain(*(((40 - 10 * i, 8 * i + 8), (30 - 10 * i, 8 * i + 8)) for i in range(4)))]
MODELS = pathlib.Path(__file__).resolve().parents[3] / "shared" / "models"
DECIMATION = threading.Lock()  # fast_simplification keeps its mesh in globals
VIEWS = {"front": (0, 0), "left": (-90, 0), "right": (90, 0), "top": (0, 90)}


class Drawing:
    """What is black in a view that the command has drawn, with its scale and its size in mm."""

    program, folder, numbers = "", pathlib.Path(), itertools.count()

    def __init__(self, file):
        svg = xml.etree.ElementTree.parse(file).getroot()
        texts = " ".join(text.text for text in svg.iter() if text.tag.endswith("}text"))
        scale = re.search(r"\b([\d.]+):([\d.]+)\b", texts)
        self.scale = float(scale[1]) / float(scale[2])
        for child in list(svg):
            if child.get("class") != "view" or child.get("id") == "sheet":
                svg.remove(child)
        rough = ink_of(svg, [float(word) for word in svg.get("viewBox").split()], 2)
        x, y, width, height = np.array(cv2.boundingRect(rough)) / 2
        self.ink = ink_of(svg, (x - 2, y - 2, width + 4, height + 4), PIXELS) > 127
        self.box = np.array(cv2.boundingRect(self.ink.astype(np.uint8)))
        self.size = self.box[2:] / PIXELS


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    if done.returncode:
        raise RuntimeError(f"ended with {done.returncode}: {' '.join(os.fsdecode(done.stdout).split())[-99:]}")


def drawn(meshes, *words):
    run([Drawing.program, file := new_file("svg"), *words, *meshes])
    return Drawing(file)


def new_file(ending):
    return Drawing.folder / f"{next(Drawing.numbers)}.{ending}"


def ink_of(svg, box, pixels):
    """How black a box of a drawing is, up to 255."""
    width, height = round(box[2] * pixels), round(box[3] * pixels)
    svg.set("viewBox", f"{box[0]} {box[1]} {width / pixels} {height / pixels}")
    svg.attrib |= {"width": f"{width}px", "height": f"{height}px"}
    done = subprocess.run("rsvg-convert", input=xml.etree.ElementTree.tostring(svg), stdout=subprocess.PIPE, check=True)
    return cv2.imdecode(np.frombuffer(done.stdout, np.uint8), cv2.IMREAD_UNCHANGED)[..., 3].copy()


def frame(view):
    """Right, down and towards the eye."""
    azimuth, elevation = np.radians(VIEWS.get(view) or [float(word) for word in view.split(",")])
    towards = np.array([np.sin(azimuth) * np.cos(elevation), np.sin(elevation), np.cos(azimuth) * np.cos(elevation)])
    right = np.array([np.cos(azimuth), 0, -np.sin(azimuth)])
    return np.array([right, np.cross(right, towards), towards])


def in_pixels(places, mesh, drawing, view):
    """Places on a mesh, in pixels of the drawing."""
    corners, places = (points @ frame(view)[:2].T * drawing.scale * PIXELS for points in (mesh.vertices, places))
    return places + drawing.box[:2] + (drawing.box[2:] - 1) / 2 - (corners.max(0) + corners.min(0)) / 2


def silhouette(drawing, mesh, view):
    """The pixels along the border of what the triangles cover."""
    covered = np.zeros(drawing.ink.shape, np.uint8)
    for triangle in np.round(in_pixels(mesh.vertices, mesh, drawing, view)[mesh.faces] * 16).astype(np.int32):
        cv2.fillConvexPoly(covered, triangle, 1, shift=4)
    return covered != cv2.erode(covered, np.ones((3, 3), np.uint8))


def distance_to(mask):
    return cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE)


def outline(drawing, mesh, view, keep):
    """How thick the ink is at the thinnest place of the silhouette, in mm, and the share where it is thick enough: at
    each place the widest disc of ink whose middle is within half a pen."""
    border = silhouette(drawing, mesh, view)
    aside = round(OUTLINE / 2 * PIXELS)
    discs = cv2.dilate(distance_to(~drawing.ink), np.ones((2 * aside + 1, 2 * aside + 1), np.uint8))
    thickness = np.maximum(2 * discs - 1, 0) / PIXELS
    thin = border & (thickness < THINNEST)
    keep.append((drawing.ink, thin))
    return thickness[border].min(), 1 - thin.sum() / border.sum()


def edges_in_sight(mesh, view):
    """Places along edges: surely in sight, of those always drawn, from 40 degrees on; and of all that may be."""
    sure, maybe = [np.empty((0, 3))], [np.empty((0, 3))]
    bent = mesh.face_adjacency_angles > np.radians(1)
    outwards = mesh.face_normals[mesh.face_adjacency[bent]].sum(1) * mesh.scale * 1e-5
    ends, angles = mesh.vertices[mesh.face_adjacency_edges[bent]], mesh.face_adjacency_angles[bent]
    for (a, b), angle, aside in zip(ends, angles, outwards):
        count = int(np.linalg.norm(b - a) / mesh.scale * 400) + 5
        places = a + np.linspace(0, 1, count)[:, None] * (b - a)
        hidden = mesh.ray.intersects_any(places + aside, np.tile(frame(view)[2], (count, 1)))
        near = np.convolve(hidden, np.ones(5), "same")
        maybe.append(places[near < 5])
        if angle > np.radians(41) and count > 6:
            sure.append(places[near == 0])
    return np.concatenate(sure), np.concatenate(maybe)


def edges(drawing, mesh, view, keep, has_edges=True):
    """The share of edges in sight that is drawn, and the share of the ink that is neither at an edge nor an outline."""
    allowed = silhouette(drawing, mesh, view)
    places = edges_in_sight(mesh, view) if has_edges else 2 * [mesh.vertices[:0]]
    pixels = [np.rint(in_pixels(some, mesh, drawing, view)[:, ::-1]).astype(int) for some in places]
    sure, maybe = (tuple(np.clip(some, 0, np.array(allowed.shape) - 1).T) for some in pixels)
    allowed[maybe] = True
    missed = distance_to(drawing.ink)[sure] > 0.3 * PIXELS
    wrong = stray = drawing.ink & (distance_to(allowed) > 0.7 * PIXELS)
    shares = 1 - missed.mean() if len(missed) else 1, stray.sum() / drawing.ink.sum()
    wrong[tuple(places[missed] for places in sure)] = True
    keep.append((drawing.ink, wrong))
    return shares


def unlike(one, other, keep, flip):
    """The larger share of a drawing's ink that is farther than a pen from the other's, which is mirrored first."""
    shape = np.maximum(one.ink.shape, other.ink.shape) + 2 * PIXELS
    inks = np.zeros((2, *shape), bool)
    for ink, drawing, axis in zip(inks, (one, other), ((), flip)):
        x, y, width, height = drawing.box
        top, left = (shape - (height, width)) // 2
        ink[top:top + height, left:left + width] = np.flip(drawing.ink[y:y + height, x:x + width], axis)
    alone = [a & (distance_to(b) > INNER_PEN * PIXELS) for a, b in (inks, inks[::-1])]
    keep.append((inks.any(0), alone[0] | alone[1]))
    return max(part.sum() / ink.sum() for part, ink in zip(alone, inks))


def kept(whole, decimated, mesh, view, keep):
    """The shares of a scan's ink that has some of its decimated copy's within .7 mm, and the other way round, without
    what is within .7 mm of the silhouette."""
    reach = 0.7 * PIXELS
    away = distance_to(silhouette(whole, mesh, view)) > reach
    place = np.round(whole.box[:2] + whole.box[2:] / 2 - decimated.box[:2] - decimated.box[2:] / 2)
    moved = cv2.warpAffine(decimated.ink.astype(np.uint8), np.array([[1, 0, place[0]], [0, 1, place[1]]], float),
                           whole.ink.shape[::-1]) > 0
    inks = whole.ink & away, moved & away
    alone = [a & (distance_to(b) > reach) for a, b in (inks, inks[::-1])]
    keep.append((inks[0] | inks[1], alone[0] | alone[1]))
    return [1 - part.sum() / ink.sum() for part, ink in zip(alone, inks)]


def mesh_of(manifold):
    mesh = manifold.to_mesh()
    return trimesh.Trimesh(np.asarray(mesh.vert_properties, float)[:, :3], mesh.tri_verts)


def cone(height, below, above, sides):
    return mesh_of(Manifold.cylinder(height, below, above, sides))


def plate(corners, thickness, holes=()):
    """Cut through by holes: x, y, radius, sides."""
    area = CrossSection([corners])
    for x, y, radius, sides in holes:
        area -= CrossSection.circle(radius, sides).translate((x, y))
    return mesh_of(Manifold.extrude(area, thickness))


def rounded_box(size, fillet, steps):
    """Each face and its half of the fillets is a grid, as CAD programs write it."""
    half, points, faces = np.array(size) / 2, [], []
    bow = fillet * np.tan(np.linspace(0, np.pi / 4, steps + 1))
    places = np.arange((2 * steps + 2)**2).reshape(2 * steps + 2, -1)
    quads = np.stack([places[:-1, :-1], places[1:, :-1], places[1:, 1:], places[:-1, 1:]], -1).reshape(-1, 4)
    for axis, side in itertools.product(range(3), (-1, 1)):
        others = (axis + 1) % 3, (axis + 2) % 3
        ticks = [half[k] - fillet + bow for k in others]
        grid = np.meshgrid(*(np.append(-tick[::-1], tick) for tick in ticks), indexing="ij")
        point = np.full((places.size, 3), side * half[axis])
        point[:, others] = np.stack(grid, -1).reshape(-1, 2)
        core = np.clip(point, fillet - half, half - fillet)
        points.append(core + fillet * (point - core) / np.linalg.norm(point - core, axis=1, keepdims=True))
        faces.append((quads + len(faces) * places.size)[:, ::side][:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3))
    mesh = trimesh.Trimesh(np.concatenate(points), np.concatenate(faces), process=False)
    mesh.merge_vertices(digits_vertex=7)
    return mesh


def bumps(subdivisions, waves, depth):
    mesh = trimesh.creation.icosphere(subdivisions=subdivisions, radius=30)
    x, y, z = (mesh.vertices * waves / 30).T
    mesh.vertices *= (1 + depth * np.sin(x + 1) * np.cos(y) * np.sin(z + 0.5))[:, None]
    return mesh


def folded_needle(side, at, width):
    """A flat square of four triangles, one of which is folded over by the width."""
    middle = (side * at + width, side * at - width, 0)
    return trimesh.Trimesh([(0, 0, 0), (side, 0, 0), (side, side, 0), (0, side, 0), middle],
                           [(0, 1, 2), (0, 2, 4), (0, 4, 3), (4, 2, 3)], process=False)


def turned(mesh, seed):
    random = np.random.default_rng(seed).random(3)
    return mesh.copy().apply_transform(trimesh.transformations.random_rotation_matrix(random))


def changed(mesh, scale, turns=False):
    """Scaled by three factors, and the faces turned about."""
    return trimesh.Trimesh(mesh.vertices * scale, mesh.faces[:, ::-1] if turns else mesh.faces, process=False)


def in_stl(mesh):
    mesh.export(file := new_file("stl"))
    return file


def in_obj(vertices, faces):
    """With all digits of doubles, and with polygons."""
    file = new_file("obj")
    file.write_text("".join(f"v {' '.join(map(repr, map(float, vertex)))}\n" for vertex in vertices) +
                    "".join(f"f {' '.join(str(corner + 1) for corner in face)}\n" for face in faces))
    return file


def with_middles(vertices, edges, on_both_sides):
    """A box with one more vertex in the middle of edges, of one of the two faces there or of both."""
    vertices, faces = list(vertices), [list(face) for face in SIDES]
    for a, b in edges:
        vertices.append((vertices[a] + vertices[b]) / 2)
        for face in faces:
            for i, pair in enumerate(zip(face, face[1:] + face[:1])):
                if pair == (a, b) or on_both_sides and pair == (b, a):
                    face.insert(i + 1, len(vertices) - 1)
                    break
    return in_obj(vertices, faces)


def two_boxes(size, gap):
    """Side by side, in one file."""
    corners = CORNERS * size
    return in_obj([*corners, *(corners + (size[0] + gap, 0, 0))], SIDES + [[i + 8 for i in side] for side in SIDES])


def polyhedra():
    """Names, meshes and views: edges are sharp, or too blunt to tell."""
    random = np.random.default_rng(40)
    for number in range(6):
        size = random.uniform(4, 60, 3) if number % 2 else (40, *random.uniform(1.5, 12, 2))
        name, box = "box " + " x ".join(f"{side:.1f}" for side in size), trimesh.creation.box(size)
        yield name, box, ("top", "front", "-35,20")[number % 3]
        yield name + ", turned", turned(box, number), "front"
    for sides, view in ((3, "left"), (5, "35,25"), (6, "top"), (8, "left"), (12, "20,-40")):
        yield f"prism of {sides}", cone(50, 20, 20, sides), view
        yield f"prism of {sides}, turned", turned(cone(8, 25, 25, sides), sides), "front"
    for count in (4, 5, 9):
        yield f"hull of {count} points", mesh_of(Manifold.hull_points(random.uniform(-30, 30, (count, 3)))), "front"
    wedge = plate([(0, 0), (60, 0), (60, 6)], 10)
    yield from (("wedge", wedge, "front"), ("wedge, turned", turned(wedge, 3), "front"))
    yield from (("L-plate", plate(L, 5), "front"), ("L-plate from above", plate(L, 5), "30,40"))
    pierced = plate(L, 6, [(7, 36, 4, 6), (45, 6, 3, 4), (8, 8, 5, 5)])
    yield from (("pierced plate", pierced, "front"), ("pierced plate, turned", turned(pierced, 8), "front"))
    yield from (("comb", plate(COMB, 4), "front"), ("stairs", plate(STAIRS, 30), "-30,30"))
    yield from (("comb, turned", turned(plate(COMB, 20), 7), "front"), ("steps", turned(plate(STAIRS, 9), 9), "front"))


def round_parts():
    """Names, meshes and views."""
    yield from (("cone", cone(50, 20, 0, 64), "15,-70"), ("cone, turned", turned(cone(60, 12, 0, 48), 2), "front"))
    yield from (("truncated cone", cone(20, 30, 12, 90), "0,-60"), ("disc", cone(3, 30, 30, 128), "right"))
    yield "torus", trimesh.creation.torus(25, 8, major_sections=96, minor_sections=48), "20,-50"
    yield "thin torus", turned(trimesh.creation.torus(25, 4, major_sections=128, minor_sections=32), 4), "front"
    yield "lens", changed(trimesh.creation.icosphere(4, 30), (1, 0.2, 1)), "front"
    yield from (("bumps", bumps(5, 7, 0.3), "front"), ("bumps, fine", bumps(6, 11, 0.15), "40,20"))
    vase = CrossSection([[(0, 0), (20, 0), (28, 15), (22, 35), (10, 45), (14, 55), (0, 55)]])
    yield "vase", mesh_of(Manifold.revolve(vase, 72)), "0,-75"
    yield "drilled plate", plate(L, 6, [(8, 36, 5, 64), (45, 6, 4, 32), (8, 8, 6, 48)]), "25,30"
    drilled = mesh_of(Manifold.cube((50, 30, 20)) - Manifold.cylinder(40, 8, 8, 60).translate((20, 14, -5)) -
                      Manifold.cylinder(80, 5, 5, 40).rotate((0, 90, 0)).translate((-5, 14, 10)))
    yield from (("drilled block", drilled, "-30,25"), ("drilled block, turned", turned(drilled, 6), "front"))
    for fillet, steps, view in ((1, 6, "30,20"), (1.5, 12, "10,70"), (2, 6, "front"), (3, 12, "30,20")):
        yield f"phone's case, fillets of {fillet}", rounded_box((140, 70, 8), fillet, steps), view
    yield "phone's case, lying", rounded_box((140, 8, 70), 1, 6), "front"


def judge_part(keep, mesh, view, is_polyhedron):
    """Figures in words, each with whether it is right, as those below; ink and what is wrong of it are kept."""
    drawing = drawn([in_stl(mesh)], "--views", view)
    size = np.ptp(mesh.vertices @ frame(view).T, axis=0)[:2] * drawing.scale
    off = np.abs(drawing.size - size - OUTLINE).max()
    is_right = off < (0.15 if is_polyhedron else 0.25) and size.max() > FULL_PEN  # round contours are smoothed
    yield f"{size[0]:.1f} x {size[1]:.1f} mm, off by {off:.2f}", is_right
    thinnest, share = outline(drawing, mesh, view, keep)
    yield f"outline: at least {thinnest:.2f} mm of ink, {share:.4f} whole", share == 1
    if is_polyhedron:
        found, stray = edges(drawing, mesh, view, keep)
        yield f"edges: {found:.4f} drawn, {stray:.4f} of the ink elsewhere", found > 0.995 and stray < 0.002


def judge_likeness(keep, one, other, share=0.01, flip=()):
    figure = unlike(drawn(*one), drawn(*other), keep, flip)
    yield f"{100 * figure:.2f} % of the ink is not in both", figure <= share


def judge_decimation(keep, model, view, least):
    """`least`: by the number of triangles, shares of the scan's ink that is kept, and of the ink that is the scan's."""
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
    whole = drawn([in_obj(mesh.vertices, mesh.faces)], "--views", view)
    for count, shares in least.items():
        with DECIMATION:
            decimated = fast_simplification.simplify(mesh.vertices.astype(np.float32), mesh.faces.astype(np.int32),
                                                     target_count=count)
        found = kept(whole, drawn([in_obj(*decimated)], "--views", view), mesh, view, keep)
        right = all(np.array(found) > shares)
        yield f"{count}: {found[0]:.3f} of the scan's ink kept, {found[1]:.3f} of the ink is its", right


def judge_flatness(keep, file, mesh):
    _, stray = edges(drawn([file]), mesh, "front", keep, has_edges=False)
    yield f"{stray:.4f} of the ink is in a flat face", stray < 0.002


def judge_window(keep, window, meshes):
    """A sheet of two, in both orders."""
    inks = []
    for order in (meshes, meshes[::-1]):
        run([window, "--picture", sheet := new_file("png"), "--size", "600x450", "--view", "30,35", *order])
        dark = cv2.imread(str(sheet), cv2.IMREAD_GRAYSCALE) < 128
        inks.append([half.sum() for half in np.array_split(dark, 2, axis=1)])
    figure = max(abs(a / b - 1) for a, b in zip(inks[0], inks[1][::-1]))
    yield f"{100 * figure:.2f} % more ink or less in another order", figure < 0.02


def cases(window):
    """Names, what judges them, and its words."""
    boxes = [in_obj(corners * (40, 30, 20), SIDES) for corners in (CORNERS, 2 * CORNERS, CORNERS[::-1])]
    if window:
        cylinder = in_stl(cone(40, 15, 15, 32))
        yield "window: boxes", judge_window, dict(window=window, meshes=boxes[:2])
        yield "window: box and cylinder", judge_window, dict(window=window, meshes=[boxes[2], cylinder])
    random_parts = [(*part, True) for part in polyhedra()] + [(*part, False) for part in round_parts()]
    parts = {name: dict(mesh=mesh, view=view, is_polyhedron=flag) for name, mesh, view, flag in random_parts}
    for name, words in parts.items():
        yield name, judge_part, words
    chosen = "drilled plate|drilled block|torus|bumps$|vase|hull of 9 points|phone"
    for name in (name for name in parts if re.match(chosen, name)):
        mesh, view = parts[name]["mesh"], parts[name]["view"]
        azimuth, elevation = VIEWS.get(view) or view.split(",")
        plain = [in_stl(mesh)], "--views", view
        mirrored = [in_stl(changed(mesh, (-1, 1, 1), turns=True))], "--views", f"{-int(azimuth)},{elevation}"
        yield f"mirrored {name}", judge_likeness, dict(one=plain, other=mirrored, flip=1)
        for change, file, *words in (("inside out:", in_stl(changed(mesh, 1, turns=True))),
                                     ("in metres:", in_stl(changed(mesh, 1e-3)), "--unit", "m"),
                                     ("moved to 4e5, 5.8e6:", in_obj(mesh.vertices + [4e5, 5.8e6, 30], mesh.faces))):
            yield f"{change} {name}", judge_likeness, dict(one=plain, other=([file], *words, "--views", view))
    for size, flip in itertools.product(((140, 70, 8), (140, 8, 70)), (0, 1)):
        case = [in_stl(rounded_box(size, 1, 6))],
        yield f"symmetry of a case of {size}, {flip}", judge_likeness, dict(one=case, other=case, flip=flip)
    for size, cut in (((40, 30, 20), [(7, 6)]), ((60, 8, 30), [(6, 5), (7, 6)]), ((25, 30, 40), [(6, 2), (5, 6)])):
        twins = [([with_middles(CORNERS * size, cut, both)], "--views", "30,30") for both in (False, True)]
        yield f"T-junctions {size}", judge_likeness, dict(one=twins[0], other=twins[1])
    for size, view in (((40, 30, 20), "30,30"), ((60, 8, 30), "front"), ((25, 30, 40), "-40,25")):
        twins = [([two_boxes(size, gap)], "--views", view) for gap in (0, 1e-5)]
        yield f"flush boxes {size}", judge_likeness, dict(one=twins[0], other=twins[1])
    for side, at, width in ((100, 0.5, 0.001), (60, 0.3, 0.0005), (150, 0.62, 0.002)):
        mesh = folded_needle(side, at, width)
        yield f"folded needle, {side}", judge_flatness, dict(file=in_obj(mesh.vertices, mesh.faces), mesh=mesh)
        mesh = turned(mesh, side)
        yield f"folded needle, {side}, turned", judge_flatness, dict(file=in_stl(mesh), mesh=mesh)
    scans = {"igea.ply": ("front", {100000: (0.72, 0.88), 50000: (0.58, 0.84), 20000: (0.37, 0.75)}),
             "armadillo.obj": ("180,0", {50000: (0.85, 0.93), 20000: (0.47, 0.82)})}  # of 86,482
    for name, (view, least) in scans.items():
        if not (model := MODELS / f"{name}.gz").exists():
            print(f"skipped: there is no {model}")
            continue
        yield f"{name} of fewer triangles", judge_decimation, dict(model=model, view=view, least=least)
    files = [in_stl(parts["drilled block"]["mesh"]), in_stl(changed(parts["torus"]["mesh"], 0.5))]
    orders = [(order, "--views", "30,30") for order in (files, files[::-1])]
    yield "order of files", judge_likeness, dict(one=orders[0], other=orders[1], share=0)


def judged(name, judge, words, pictures):
    keep, found = [], []
    try:
        found += judge(keep, **words)
    except (RuntimeError, AttributeError, subprocess.SubprocessError) as reason:
        found.append((str(reason), False))
    for number, (ink, wrong) in enumerate(keep):
        if pictures and wrong.any():
            picture = np.where(ink[..., None], np.uint8([99] * 3), np.uint8([255] * 3))
            picture[distance_to(wrong) < 5] = 0, 0, 255
            cv2.imwrite(str(pictures / f"{name} {number}.png"), picture[::3, ::3])
    return [(name, *figure) for figure in found]


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
        rows = sum(pool.map(lambda case: judged(*case, options.pictures), chosen, chunksize=1), [])
    for name, figure, right in rows:
        print(f"{name:46} {figure:62} {'' if right else 'WRONG'}".rstrip())
    wrong = sum(not right for *_, right in rows)
    sys.exit(f"{wrong} of {len(rows)} figures are wrong" if wrong else 0)


if __name__ == "__main__":
    main()
