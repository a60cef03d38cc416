# SPDX-License-Identifier: GPL-3.0-or-later
"""How strongly the normal bends: |Δn| on a mesh, seen along −z, with Matplotlib.

    ./run --python docs/examples/plot_laplacian.py MESH PICTURE.png
"""

import sys

import laplacian_lines
import matplotlib
import matplotlib.figure
import numpy
from matplotlib.collections import PolyCollection

if len(sys.argv) != 3:
    sys.exit("usage: plot_laplacian.py MESH PICTURE.png")
_, mesh, picture = sys.argv
try:
    vertices, triangles = laplacian_lines.read_mesh(mesh)
    # A larger kernel_size, a length, shows less of the noise. 0 is automatic.
    surface = laplacian_lines.Surface((vertices, triangles), kernel_size=0)
except (OSError, laplacian_lines.Error) as error:
    sys.exit(f"{mesh} cannot be plotted: {error}")

# The results are arrays with a row per vertex. Δn has the unit 1/length²; times the square of the kernel size it is a
# number without a unit, the same for a model in millimetres and in metres. Vertices without a triangle hold zeros.
field = surface.field()
bending = numpy.linalg.norm(field["ll_laplacian_normal"], axis=1) * surface.measures()["kernel_size"] ** 2
low, high = numpy.percentile(bending[field["ll_normal"].any(axis=1)], (2, 98))

# Triangles that face the eye, the farthest first, darker where they turn away.
corners = vertices[triangles]
facing = field["ll_normal"][triangles].mean(axis=1)[:, 2]
order = numpy.argsort(corners[:, :, 2].mean(axis=1))
order = order[facing[order] > 0]
colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(low, high), "magma")
shaded = colours.to_rgba(bending[triangles].mean(axis=1))[order]
shaded[:, :3] *= (0.35 + 0.65 * facing[order].clip(0, 1))[:, None]

figure = matplotlib.figure.Figure(figsize=(6, 6), layout="constrained")
axes = figure.add_subplot(aspect="equal")
axes.set_axis_off()
axes.add_collection(PolyCollection(corners[order, :, :2], facecolors=shaded, edgecolors=shaded, linewidths=0.3))
axes.autoscale()
figure.colorbar(colours, ax=axes, location="bottom", shrink=0.6, label="|Δn| h")
figure.savefig(picture, dpi=120)
print(f"written: {picture}")
