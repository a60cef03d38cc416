# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter's attributes in a PLY file that MeshLab saves: on a torus they are close to what mathematics says, and the
mesh itself stays as it was."""
from math import cos, hypot, inf, sin, tau

from harness import *

RINGS, SIDES, R = 240, 120, 0.4  # the bumpy torus without its bumps, axis z


def rows(file, header="end_header\n"):
    return [line.split() for line in text_of(file).split(header)[1].splitlines()]


faces = [" ".join(row) for row in (line.split() for line in bumpy_torus(RINGS, SIDES).splitlines()) if row[0] == "3"
         and len(row) == 4]
angles = [(tau * i / RINGS, tau * j / SIDES) for i in range(RINGS) for j in range(SIDES)]
ply("torus.ply", [f"{(1 + R * cos(v)) * cos(u):.6f} {(1 + R * cos(v)) * sin(u):.6f} {R * sin(v):.6f}" for u,
                  v in angles], faces)
before = rows("torus.ply")
drive(f"wait\nopen torus.ply\ntrigger Compute Laplacian Lines\napply\nclose\n{save_attributes('off')}")

after, lists = rows("torus.ply"), "property list uchar float ll_" in text_of("torus.ply")
worst = {}


def note(name, error):
    worst[name] = max(worst.get(name, 0), abs(error) if error == error else inf)


for row in after[:RINGS * SIDES]:
    if lists:  # from 2022.02 on, MeshLab writes a point attribute as a list, its length 3 glued to the number before it
        row = row[:4] + row[5:]
        row[6:15:3] = [word.removesuffix("3") for word in row[6:15:3]]
    # |A|² is the sum of the squared curvatures
    x, y, _, kernel, *values = map(float, row)
    d, n, diagonal, rest = (values[i:i + 3] for i in (0, 3, 6, 9))
    rho = hypot(x, y)
    c, s, k = (rho - 1) / R, float(row[2]) / R, 1 / R
    l, ex, ey = c / rho, x / rho, y / rho
    normal = c * ex, c * ey, s
    note("normal", 1 - sum(a * b for a, b in zip(n, normal)))
    note("laplacian", sum(a * b for a, b in zip(d, normal)) / (k * k + l * l) + 1)
    note("shape", (diagonal[0] - k * s * s * ex * ex - l * ey * ey) / k)
    note("shape", (diagonal[1] - k * s * s * ey * ey - l * ex * ex) / k)
    note("shape", (diagonal[2] - k * c * c) / k)
    note("shape", (rest[0] + k * s * c * ey) / k)
    note("shape", (rest[1] + k * s * c * ex) / k)
    note("shape", (rest[2] - (k * s * s - l) * ex * ey) / k)
    note("kernel", kernel / 0.053984 - 1)
say(f"{len(after)} lines; largest errors: {worst}")
for name, most in {"normal": 1e-4, "laplacian": 0.02, "shape": 0.02, "kernel": 1e-4}.items():
    expect(worst[name] < most, f"{name} is not that of a torus: off by {worst[name]}")
same = all([round(float(a), 5) for a in x[:3]] == [round(float(b), 5) for b in y[:3]] for x,
           y in zip(before[:len(angles)], after))
expect(same and before[len(angles):] == after[len(angles):], "the filter changed the mesh")
