# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions that drawings are held against exact lines from: towards the viewer, as frames of the picture."""

import itertools
import math

import numpy

FACES, EDGES, CORNERS, ASIDE_BY_A_HAIR, ASIDE_BY_A_DEGREE, GENERIC = range(6)
GENERIC_ANGLES = [(23, 31), (-52, 17), (117, 43), (-149, -26)]  # azimuth, elevation


def unit(vector):
    return vector / numpy.linalg.norm(vector)


def frame_towards(viewer):
    """Right, up, towards the viewer; z is up as far as it can be."""
    viewer = unit(numpy.array(viewer, float))
    up = numpy.array([0, 0, 1.0] if abs(viewer[2]) < 0.99 else [0, 1.0, 0])
    right = unit(numpy.cross(up, viewer))
    return numpy.array([right, numpy.cross(viewer, right), viewer])


def turned_aside(frame, angle):
    """The viewer goes aside by the angle, in a direction that no edge of a part has."""
    axis = math.cos(0.6) * frame[0] + math.sin(0.6) * frame[1]
    return numpy.array([turned_about(axis, vector, angle) for vector in frame])


def turned_about(axis, vector, angle):
    along = axis * (axis @ vector)
    return along + (vector - along) * math.cos(angle) + numpy.cross(axis, vector) * math.sin(angle)


def of_cube():
    """Names, classes and frames of a cube's 6 faces, 12 edges and 8 corners."""
    for viewer in itertools.product((0, 1, -1), repeat=3):
        if any(viewer):
            name = "".join("0+-"[sign] for sign in viewer)
            yield name, numpy.count_nonzero(viewer) - 1, frame_towards(viewer)


def all_directions():
    """(name, class, frame) of each: 82."""
    found = []
    for name, kind, frame in of_cube():
        found.append((name, kind, frame))
        found.append((name + " by 1e-6", ASIDE_BY_A_HAIR, turned_aside(frame, 1e-6)))
        found.append((name + " by 1 degree", ASIDE_BY_A_DEGREE, turned_aside(frame, math.radians(1))))
    for azimuth, elevation in GENERIC_ANGLES:
        a, e = math.radians(azimuth), math.radians(elevation)
        viewer = (math.cos(e) * math.sin(a), -math.cos(e) * math.cos(a), math.sin(e))
        found.append((f"{azimuth},{elevation}", GENERIC, frame_towards(viewer)))
    return found
