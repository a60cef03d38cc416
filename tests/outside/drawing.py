# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of the command, and figures of what is right in them, by rsvg-convert, OpenCV and trimesh alone.

A figure compares pixels of ink with where ink has to be, or may be: along the silhouette, which is the border of what the
triangles cover, and along edges, of which trimesh's rays tell what is in sight. Functions also return a picture: the ink,
and the pixels that are wrong."""

import itertools
import os
import pathlib
import re
import subprocess
import xml.etree.ElementTree

import cv2
import numpy as np

PIXELS = 20  # a millimetre
OUTLINE_PEN, INNER_PEN = 0.5, 0.25  # mm
THINNEST = 0.35  # mm of ink that are enough of an outline
NEAR = 0.7  # mm: nearer places count as the same line
VIEWS = {"front": (0, 0), "left": (-90, 0), "right": (90, 0), "top": (0, 90)}  # azimuth and elevation, degrees


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


def in_stl(mesh):
    mesh.export(file := new_file("stl"))
    return file


def in_obj(vertices, faces):
    """With all digits of doubles, and with polygons."""
    file = new_file("obj")
    file.write_text("".join(f"v {' '.join(map(repr, map(float, vertex)))}\n" for vertex in vertices) +
                    "".join(f"f {' '.join(str(corner + 1) for corner in face)}\n" for face in faces))
    return file


def ink_of(svg, box, pixels):
    """How black a box of a drawing is, up to 255."""
    width, height = round(box[2] * pixels), round(box[3] * pixels)
    svg.set("viewBox", f"{box[0]} {box[1]} {width / pixels} {height / pixels}")
    svg.attrib |= {"width": f"{width}px", "height": f"{height}px"}
    done = subprocess.run("rsvg-convert", input=xml.etree.ElementTree.tostring(svg), stdout=subprocess.PIPE, check=True)
    return cv2.imdecode(np.frombuffer(done.stdout, np.uint8), cv2.IMREAD_UNCHANGED)[..., 3].copy()


def angles(view):
    """Azimuth and elevation, degrees."""
    return VIEWS.get(view) or [float(word) for word in view.split(",")]


def frame(view):
    """Right, down and towards the eye."""
    azimuth, elevation = np.radians(angles(view))
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


def outline(drawing, mesh, view):
    """How thick the ink is at the thinnest place of the silhouette, in mm, and the share where it is thick enough: at each
    place the widest disc of ink whose middle is within half a pen."""
    border = silhouette(drawing, mesh, view)
    aside = round(OUTLINE_PEN / 2 * PIXELS)
    discs = cv2.dilate(distance_to(~drawing.ink), np.ones((2 * aside + 1, 2 * aside + 1), np.uint8))
    thickness = np.maximum(2 * discs - 1, 0) / PIXELS
    thin = border & (thickness < THINNEST)
    return thickness[border].min(), 1 - thin.sum() / border.sum(), (drawing.ink, thin)


def edges_in_sight(mesh, view):
    """Places along edges: those surely in sight, where none of five in a row is hidden, of edges that are always drawn, from
    40 degrees on and one to spare; and those that may be, where not all five are, and the two last ones at each end."""
    sure, maybe = [np.empty((0, 3))], [np.empty((0, 3))]
    bent = mesh.face_adjacency_angles > np.radians(1)
    ends, bends = mesh.vertices[mesh.face_adjacency_edges[bent]], mesh.face_adjacency_angles[bent]
    outwards = mesh.face_normals[mesh.face_adjacency[bent]].sum(1) * mesh.scale * 1e-5  # rays start off the surface
    for (a, b), bend, aside in zip(ends, bends, outwards):
        count = int(np.linalg.norm(b - a) / mesh.scale * 400) + 5
        places = a + np.linspace(0, 1, count)[:, None] * (b - a)
        hidden = mesh.ray.intersects_any(places + aside, np.tile(frame(view)[2], (count, 1)))
        near = np.convolve(hidden, np.ones(5), "same")
        maybe.append(places[near < 5])
        if bend > np.radians(41) and count > 6:
            sure.append(places[near == 0])
    return np.concatenate(sure), np.concatenate(maybe)


def edges(drawing, mesh, view, has_edges=True):
    """The share of edges in sight that is drawn, and the share of the ink that is neither at an edge nor an outline."""
    allowed = silhouette(drawing, mesh, view)
    places = edges_in_sight(mesh, view) if has_edges else 2 * [mesh.vertices[:0]]
    pixels = [np.rint(in_pixels(some, mesh, drawing, view)[:, ::-1]).astype(int) for some in places]
    sure, maybe = (tuple(np.clip(some, 0, np.array(allowed.shape) - 1).T) for some in pixels)
    allowed[maybe] = True
    missed = distance_to(drawing.ink)[sure] > 0.3 * PIXELS
    stray = drawing.ink & (distance_to(allowed) > NEAR * PIXELS)
    found = 1 - missed.mean() if len(missed) else 1
    wrong = stray.copy()
    wrong[tuple(axis[missed] for axis in sure)] = True
    return found, stray.sum() / drawing.ink.sum(), (drawing.ink, wrong)


def unlike(one, other, flip):
    """The larger share of a drawing's ink that is farther than a pen from the other's, which is mirrored first."""
    shape = np.maximum(one.ink.shape, other.ink.shape) + 2 * PIXELS
    inks = np.zeros((2, *shape), bool)
    for ink, drawing, axis in zip(inks, (one, other), ((), flip)):
        x, y, width, height = drawing.box
        top, left = (shape - (height, width)) // 2
        ink[top:top + height, left:left + width] = np.flip(drawing.ink[y:y + height, x:x + width], axis)
    alone = ink_alone(inks, INNER_PEN)
    return max(part.sum() / ink.sum() for part, ink in zip(alone, inks)), (inks.any(0), alone[0] | alone[1])


def kept(whole, decimated, mesh, view):
    """The share of a scan's ink that is near some of its decimated copy's, and the other way round, without what is near the
    silhouette."""
    away = distance_to(silhouette(whole, mesh, view)) > NEAR * PIXELS
    x, y = np.round(whole.box[:2] + whole.box[2:] / 2 - decimated.box[:2] - decimated.box[2:] / 2)
    moved = cv2.warpAffine(decimated.ink.astype(np.uint8), np.array([[1, 0, x], [0, 1, y]], float), whole.ink.shape[::-1]) > 0
    inks = whole.ink & away, moved & away
    alone = ink_alone(inks, NEAR)
    return *(1 - part.sum() / ink.sum() for part, ink in zip(alone, inks)), (inks[0] | inks[1], alone[0] | alone[1])


def ink_alone(inks, reach):
    """Of each of two, the ink that has none of the other's within `reach` mm."""
    return [a & (distance_to(b) > reach * PIXELS) for a, b in (inks, inks[::-1])]
