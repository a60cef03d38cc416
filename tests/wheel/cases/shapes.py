# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of which all is known, and the reference that programs in C++ have written."""

import os
import pathlib

import numpy

REFERENCE = pathlib.Path(os.environ["LAPLACIAN_LINES_REFERENCE"])


def torus(m=96, n=48, bumps=0.0):
    """Of the radii 1 and 0.4 around z; along its axis it has two outlines, circles of the radii 1.4 and 0.6."""
    u, v = numpy.meshgrid(*(2 * numpy.pi * numpy.arange(k) / k for k in (m, n)), indexing="ij")
    small = 0.4 + bumps * numpy.cos(8 * u) * numpy.cos(4 * v)
    r = 1 + small * numpy.cos(v)
    number = numpy.arange(m * n).reshape(m, n)
    right, above = numpy.roll(number, -1, axis=0), numpy.roll(number, -1, axis=1)
    both = numpy.roll(above, -1, axis=0)
    faces = [numpy.stack(corners, axis=-1).reshape(-1, 3) for corners in ((number, right, both), (number, both, above))]
    points = numpy.stack([r * numpy.cos(u), r * numpy.sin(u), small * numpy.sin(v)], axis=-1)
    return points.reshape(-1, 3), numpy.concatenate(faces)


def bumpy():
    """With Laplacian lines at the feet of its bumps."""
    return torus(192, 96, 0.06)


def sphere(radius=2.0, steps=4):
    """An octahedron, divided."""
    points = numpy.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    faces = numpy.array([[x, y, z] if (x + y + z) % 2 == 0 else [y, x, z] for x in (0, 1) for y in (2, 3) for z in (4, 5)])
    for _ in range(steps):
        edges = numpy.sort(numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, place = numpy.unique(edges, axis=0, return_inverse=True)
        a, b, c = (len(points) + place.reshape(-1)).reshape(3, -1)
        middles = points[unique].sum(axis=1)
        points = numpy.concatenate([points, middles / numpy.linalg.norm(middles, axis=1)[:, None]])
        x, y, z = faces.T
        faces = numpy.concatenate([numpy.stack(t, axis=1) for t in ((x, a, c), (a, y, b), (c, b, z), (a, b, c))])
    return radius * points, faces
