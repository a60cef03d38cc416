# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes for which nothing was tuned: parts as CAD programs write them, sizes in mm."""

import itertools

import numpy as np
import trimesh
from manifold3d import CrossSection, Manifold

BOX = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])  # corners of a unit cube
BOX_FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]

# Outlines of plates. A comb has seven teeth of 5 mm; stairs have four steps.
L = [(0, 0), (60, 0), (60, 12), (15, 12), (15, 45), (0, 45)]
COMB = [(0, 0), (70, 0), *((x, (20, 4)[i % 2]) for i in range(14) for x in (70 - 5 * i, 65 - 5 * i))]
STAIRS = [(0, 0), (40, 0), *((x, 8 * i + 8) for i in range(4) for x in (40 - 10 * i, 30 - 10 * i))]


def mesh_of(manifold):
    mesh = manifold.to_mesh()
    return trimesh.Trimesh(np.asarray(mesh.vert_properties, float)[:, :3], mesh.tri_verts)


def cone(height, below, above, sides):
    return mesh_of(Manifold.cylinder(height, below, above, sides))


def plate(corners, thickness, holes=()):
    """An outline as a solid, cut through by holes: x, y, radius, sides."""
    area = CrossSection([corners])
    for x, y, radius, sides in holes:
        area -= CrossSection.circle(radius, sides).translate((x, y))
    return mesh_of(Manifold.extrude(area, thickness))


def rounded_face(half, fillet, bow, axis, side):
    """Points of a grid on a face of the sharp box, each moved to the distance `fillet` from the nearest place of the core,
    which is smaller by the fillet on all sides. `bow`: steps beyond the core that become even along the fillet."""
    others = (axis + 1) % 3, (axis + 2) % 3
    ticks = [half[k] - fillet + bow for k in others]
    grid = np.stack(np.meshgrid(*(np.append(-tick[::-1], tick) for tick in ticks), indexing="ij"), -1).reshape(-1, 2)
    point = np.full((len(grid), 3), side * half[axis])
    point[:, others] = grid
    core = np.clip(point, fillet - half, half - fillet)
    return core + fillet * (point - core) / np.linalg.norm(point - core, axis=1, keepdims=True)


def rounded_box(size, fillet, steps):
    """Each face and its half of the fillets is a grid, as CAD programs write it."""
    half, bow = np.array(size) / 2, fillet * np.tan(np.linspace(0, np.pi / 4, steps + 1))
    places = np.arange((2 * steps + 2)**2).reshape(2 * steps + 2, -1)
    quads = np.stack([places[:-1, :-1], places[1:, :-1], places[1:, 1:], places[:-1, 1:]], -1).reshape(-1, 4)
    points, faces = [], []
    for axis, side in itertools.product(range(3), (-1, 1)):
        faces.append((quads + len(faces) * places.size)[:, ::side][:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3))
        points.append(rounded_face(half, fillet, bow, axis, side))
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
    """Scaled by a factor, or three; `turns`: with the faces turned about."""
    return trimesh.Trimesh(mesh.vertices * scale, mesh.faces[:, ::-1] if turns else mesh.faces, process=False)


def with_middles(vertices, edges, on_both_sides):
    """Vertices and faces of a box with one more vertex in the middle of edges, of one of the two faces there or of both."""
    vertices, faces = list(vertices), [list(face) for face in BOX_FACES]
    for a, b in edges:
        vertices.append((vertices[a] + vertices[b]) / 2)
        for face in faces:
            for i, pair in enumerate(zip(face, face[1:] + face[:1])):
                if pair == (a, b) or on_both_sides and pair == (b, a):
                    face.insert(i + 1, len(vertices) - 1)
                    break
    return vertices, faces


def two_boxes(size, gap):
    """Vertices and faces of two boxes side by side."""
    corners = BOX * size
    return [*corners, *(corners + (size[0] + gap, 0, 0))], BOX_FACES + [[i + 8 for i in face] for face in BOX_FACES]


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
    pierced = plate(L, 6, [(7, 36, 4, 6), (45, 6, 3, 4), (8, 8, 5, 5)])
    yield "wedge", wedge, "front"
    yield "wedge, turned", turned(wedge, 3), "front"
    yield "L-plate", plate(L, 5), "front"
    yield "L-plate from above", plate(L, 5), "30,40"
    yield "pierced plate", pierced, "front"
    yield "pierced plate, turned", turned(pierced, 8), "front"
    yield "comb", plate(COMB, 4), "front"
    yield "comb, turned", turned(plate(COMB, 20), 7), "front"
    yield "stairs", plate(STAIRS, 30), "-30,30"
    yield "steps", turned(plate(STAIRS, 9), 9), "front"


def round_parts():
    """Names, meshes and views."""
    yield "cone", cone(50, 20, 0, 64), "15,-70"
    yield "cone, turned", turned(cone(60, 12, 0, 48), 2), "front"
    yield "truncated cone", cone(20, 30, 12, 90), "0,-60"
    yield "disc", cone(3, 30, 30, 128), "right"
    yield "torus", trimesh.creation.torus(25, 8, major_sections=96, minor_sections=48), "20,-50"
    yield "thin torus", turned(trimesh.creation.torus(25, 4, major_sections=128, minor_sections=32), 4), "front"
    yield "lens", changed(trimesh.creation.icosphere(4, 30), (1, 0.2, 1)), "front"
    yield "bumps", bumps(5, 7, 0.3), "front"
    yield "bumps, fine", bumps(6, 11, 0.15), "40,20"
    vase = CrossSection([[(0, 0), (20, 0), (28, 15), (22, 35), (10, 45), (14, 55), (0, 55)]])
    yield "vase", mesh_of(Manifold.revolve(vase, 72)), "0,-75"
    yield "drilled plate", plate(L, 6, [(8, 36, 5, 64), (45, 6, 4, 32), (8, 8, 6, 48)]), "25,30"
    drilled = mesh_of(Manifold.cube((50, 30, 20)) - Manifold.cylinder(40, 8, 8, 60).translate((20, 14, -5)) -
                      Manifold.cylinder(80, 5, 5, 40).rotate((0, 90, 0)).translate((-5, 14, 10)))
    yield "drilled block", drilled, "-30,25"
    yield "drilled block, turned", turned(drilled, 6), "front"
    for fillet, steps, view in ((1, 6, "30,20"), (1.5, 12, "10,70"), (2, 6, "front"), (3, 12, "30,20")):
        yield f"phone's case, fillets of {fillet}", rounded_box((140, 70, 8), fillet, steps), view
    yield "phone's case, lying", rounded_box((140, 8, 70), 1, 6), "front"
