# SPDX-License-Identifier: GPL-3.0-or-later
"""What a part's file holds: its meshes, and its exact lines from each direction. part_file.cpp reads it. All of it is
packed by zlib behind its length in four bytes, the highest first; numbers in it have the lowest byte first.

  text                    8 bytes, "LLTRUTH1"
  u32 meshes              of each: f64 linear, f64 angular deflection, u32 vertices, f32 x y z of each,
                          u32 triangles, u32 a b c of each
  u32 views               of each: text name, u32 class, f64 right, up, towards the viewer,
                          lines that have to be drawn, lines that may be drawn
  lines                   u32 number; of each: u32 points, i32 x, i32 y of the first, then differences, micrometres
  text                    u32 length, bytes in UTF-8
"""

import struct
import zlib

import numpy

MAGIC = b"LLTRUTH1"


def packed_lines(lines):
    packed = [struct.pack("<I", len(lines))]
    for line in lines:
        points = numpy.round(numpy.array(line) * 1000).astype("<i4")
        steps = numpy.diff(points, axis=0, prepend=numpy.zeros((1, 2), "<i4")).astype("<i4")
        packed += [struct.pack("<I", len(points)), steps.tobytes()]
    return b"".join(packed)


def packed_mesh(linear, angular, positions, triangles):
    return (
        struct.pack("<ddI", linear, angular, len(positions))
        + positions.astype("<f4").tobytes()
        + struct.pack("<I", len(triangles))
        + triangles.astype("<u4").tobytes()
    )


def packed_view(name, kind, frame, demanded, allowed):
    text = name.encode()
    return (
        struct.pack("<I", len(text))
        + text
        + struct.pack("<I", kind)
        + numpy.asarray(frame, "<f8").tobytes()
        + packed_lines(demanded)
        + packed_lines(allowed)
    )


def packed_part(meshes, views):
    """Of what packed_mesh() and packed_view() gave."""
    raw = MAGIC + struct.pack("<I", len(meshes)) + b"".join(meshes)
    raw += struct.pack("<I", len(views)) + b"".join(views)
    return struct.pack(">I", len(raw)) + zlib.compress(raw, 9)
