# SPDX-License-Identifier: GPL-3.0-or-later
"""golden.py PROGRAM [--update]: the program, of one or more words, draws twelve small meshes by default in each format as
the files in drawings/ have them. --update writes anew those that differ: look at them before you commit them. Without it,
both drawings and a PNG of each are left in the build folder, in golden/.

Files are compared byte for byte, but for the program's version and for how streams of PNG and PDF are packed, with the
lengths and places that follow from it: another zlib packs otherwise. DXF is kept packed, for it is large."""

import gzip
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import zlib

KEPT = pathlib.Path(__file__).resolve().parent / "drawings"
WORK = pathlib.Path(os.environ.get("LAPLACIAN_LINES_BUILD") or KEPT.parents[2] / "build") / "golden"
PICTURE = {"svg": "rsvg-convert --zoom=2 -o {0}.png {0}", "pdf": "pdftoppm -png -r 100 -singlefile {0} {0}"}


def surface(point, rows, columns):
    """Triangles of point(i, j)."""
    for i in range(rows):
        for j in range(columns):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            yield from ((a, c, b), (a, d, c))


def turned(profile, sides, radius=lambda r, angle: r):
    """Triangles of a profile around z, its radii and heights from below on the outside."""
    def point(i, j):
        angle = math.tau * j / sides
        r = radius(profile[i][0], angle)
        return r * math.cos(angle), r * math.sin(angle), profile[i][1]
    return list(surface(point, len(profile) - 1, sides))


def prism(sides, radius, height):
    return turned([(0, 0), (radius, 0), (radius, height), (0, height)], sides)


def arc(radius, first, last, x=0., y=0.):
    angles = [math.tau * (first + (last - first) * i / 32) for i in range(33)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def scanned(x, y, z):
    """Bumpy, with noise."""
    r = 1 + 0.08 * math.sin(0.4 * x) * math.sin(0.5 * y) + 0.001 * math.sin(1e3 * (x + 2 * y + 3 * z))
    return r * x, r * y, r * z


def tilted(triangles):
    """So that the front view sees three sides."""
    return [[((2 * x - y + 2 * z) / 3, (2 * x + 2 * y - z) / 3, (2 * y + 2 * z - x) / 3) for x, y, z in triangle]
            for triangle in triangles]


MESHES = {
    "cube.off": tilted(prism(4, 20 * math.sqrt(2), 40)),
    "tile.stl": tilted(prism(4, 20 * math.sqrt(2), 5)),
    "cylinder.stl": tilted(prism(48, 15, 50)),
    "shaft.obj": tilted(turned([(0, 0), (20, 0), (20, 10), (12, 10), (12, 40), (8, 45), (0, 45)], 64)),
    "torus.ply": tilted(turned(arc(10, 0, 1, x=30), 48)),
    "plate.stl": tilted(turned([(12, 6), (12, 0), (30, 0), (30, 6), (12, 6)], 48,
                               lambda r, a: r if r == 12 else r / max(abs(math.cos(a)), abs(math.sin(a))))),
    "star.obj": tilted(turned([(0, 0), (20, 0), (20, 15), (0, 15)], 140, lambda r, a: r * (1 + 0.3 * math.sin(7 * a)))),
    "sheet.ply": tilted(surface(lambda i, j: (2 * i, 2 * j, 9 * math.sin(0.3 * i) * math.sin(0.3 * j)), 40, 30)),
    "sphere.off": turned(arc(25, -0.25, 0.25), 48),
    "scan.ply": [[scanned(*p) for p in triangle] for triangle in turned(arc(20, -0.25, 0.25), 64)],
    "bodies.ply": tilted(prism(4, 40, 10) + turned(arc(12, -0.25, 0.25, y=22), 48)),
    "cup.off": tilted(turned([(0, 0), (16, 2), (19, 15), (18, 30), (22, 45)], 48)),
}


def write_mesh(file, triangles):
    points, faces = {}, []
    for triangle in triangles:
        face = [points.setdefault(tuple(round(x, 4) + 0. for x in p), len(points)) for p in triangle]
        faces += [face] if len({*face}) == 3 else []
    if file.suffix == ".stl":
        places = list(points)
        facets = (struct.pack("<12fH", 0, 0, 0, *(x for v in face for x in places[v]), 0) for face in faces)
        file.write_bytes(struct.pack("<80sI", b"", len(faces)) + b"".join(facets))
        return
    head = {".off": f"OFF\n{len(points)} {len(faces)} 0\n", ".obj": "", ".ply": "ply\nformat ascii 1.0\n"
            f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"}[file.suffix]
    v, f, first = ("v ", "f ", 1) if file.suffix == ".obj" else ("", "3 ", 0)
    file.write_text(head + "".join(f"{v}%.4f %.4f %.4f\n" % p for p in points) +
                    "".join(f"{f}{a + first} {b + first} {c + first}\n" for a, b, c in faces))


def compared_content(name, data):
    def plain(stream):
        words, packed = stream.groups()
        return re.sub(rb"/Length \d+", b"", words) + (zlib.decompress(packed) if b"/FlateDecode" in words else packed)

    if name.endswith(".pdf"):
        data = re.sub(rb"(<<[^\n]*>>)\nstream\n(.*?)\nendstream", plain, data.partition(b"\nxref\n")[0], flags=re.S)
    if name.endswith(".png"):
        chunks, place = [], 8
        while place < len(data):
            size, = struct.unpack_from(">I", data, place)
            chunks.append(data[place + 4:place + 8 + size])
            place += 12 + size
        packed = b"".join(chunk[4:] for chunk in chunks if chunk.startswith(b"IDAT"))
        data = b"".join(chunk for chunk in chunks if not chunk.startswith(b"IDAT")) + zlib.decompress(packed)
    return re.sub(rb'"laplacian_lines":"[^"]*"|/Creator <\w*>', b"", data)


def is_as_kept(name, new, updates):
    file, opened = (KEPT / f"{name}.gz", gzip.open) if name.endswith(".dxf") else (KEPT / name, open)
    old = opened(file, "rb").read() if file.exists() else b""
    if old and compared_content(name, new) == compared_content(name, old):
        return True
    print(f"{'written' if updates else 'not as it is kept'}: {name}")
    if updates:
        with opened(file, "wb") as kept:
            kept.write(new)
        return True
    pathlib.Path(f"kept_{name}").write_bytes(old)
    for place in (name, f"kept_{name}"):
        subprocess.run(PICTURE.get(place[-3:], "true").format(place), shell=True, check=False)
    return False


def main(*words):
    program = [os.path.abspath(word) for word in words if word != "--update"]
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    os.chdir(WORK)
    differing = 0
    for mesh, triangles in MESHES.items():
        write_mesh(pathlib.Path(mesh), triangles)
        for name in (f"{mesh.partition('.')[0]}.{ending}" for ending in ("svg", "pdf", "dxf", "png")):
            subprocess.run([*program, name, mesh], check=True, stdout=subprocess.DEVNULL)
            differing += not is_as_kept(name, pathlib.Path(name).read_bytes(), "--update" in words)
    if differing:
        sys.exit(f"{differing} drawings differ from those kept: see both in {WORK}; to keep the new ones:\n"
                 f"python3 {KEPT.parent}/golden.py {' '.join(program)} --update")


main(*sys.argv[1:])
