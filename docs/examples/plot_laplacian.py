# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# How strongly the normal bends: |Δn| on a mesh, with Matplotlib.
#
#     ./run --python docs/examples/plot_laplacian.py MESH [PICTURE.png]
#
# In a notebook or an editor with cells, put the names into the next cell instead.

# %%
import sys

MESH, PICTURE = "scan.ply", "laplacian.png"
if "ipykernel" not in sys.modules:
    if not 2 <= len(sys.argv) <= 3:
        sys.exit("usage: plot_laplacian.py MESH [PICTURE.png]")
    MESH, PICTURE = sys.argv[1:] + [PICTURE][len(sys.argv) - 2 :]

# %%
import laplacian_lines
import matplotlib
import numpy

try:
    vertices, triangles = laplacian_lines.read_mesh(MESH)
    # A larger kernel_size, a length, shows less of the noise. 0 is automatic.
    field = laplacian_lines.field((vertices, triangles), kernel_size=0)
except (OSError, laplacian_lines.Error) as error:
    sys.exit(f"{MESH} cannot be plotted: {error}")

# %% [markdown]
# The results are arrays with a row per vertex. Δn has the unit 1/length²; times the square of the kernel size it is a
# number without a unit, the same for a model in millimetres and in metres.

# %%
bending = numpy.linalg.norm(field["ll_laplacian_normal"], axis=1) * field["ll_kernel_size"] ** 2
used = field["ll_kernel_size"] > 0  # vertices without a triangle hold zeros
low, high = numpy.percentile(bending[used], (2, 98))
print(f"{len(vertices)} vertices; |Δn| h: median {numpy.median(bending[used]):.3g}, 2 to 98 %: {low:.3g} to {high:.3g}")

# %% [markdown]
# Seen along −z, with y upward: triangles that face the eye, the farthest first, darker where they turn away.

# %%
if "ipykernel" not in sys.modules:
    matplotlib.use("Agg")  # a file, no window
import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection

corners = vertices[triangles]
facing = field["ll_normal"][triangles].mean(axis=1)[:, 2]
order = numpy.argsort(corners[:, :, 2].mean(axis=1))
order = order[facing[order] > 0]

scale = matplotlib.colors.Normalize(low, high)
colours = plt.cm.magma(scale(bending[triangles].mean(axis=1)))
colours[:, :3] *= (0.35 + 0.65 * facing.clip(0, 1))[:, None]

figure, (view, histogram) = plt.subplots(1, 2, figsize=(12, 6), width_ratios=(2, 1), layout="constrained")
view.add_collection(PolyCollection(corners[order, :, :2], facecolors=colours[order], edgecolors=colours[order], linewidths=0.3))
view.autoscale()
view.set_aspect("equal")
view.set_axis_off()
figure.colorbar(plt.cm.ScalarMappable(scale, "magma"), ax=view, location="bottom", shrink=0.6, label="|Δn| h")
histogram.hist(bending[used], bins=80, range=(0, 1.5 * high), color="#5b2a86")
histogram.set_xlabel("|Δn| h")
histogram.set_ylabel("vertices")
figure.savefig(PICTURE, dpi=120)
print(f"written: {PICTURE}")
