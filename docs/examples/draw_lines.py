# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# From a scan to a line drawing, with PyMeshLab and Matplotlib; no display is needed.
#
#     ./run --python docs/examples/draw_lines.py MESH [PICTURE] [VIEW]
#
# PICTURE may be a PNG, SVG or PDF file; VIEW is Front, Back, Left, Right, Top or Bottom. In a notebook or an editor
# with cells, put the names into the next cell instead.

# %%
import sys

MESH, PICTURE, VIEW = "scan.ply", "lines.png", "Front"
if "ipykernel" not in sys.modules:
    if not 2 <= len(sys.argv) <= 4:
        sys.exit("usage: draw_lines.py MESH [PICTURE] [VIEW]")
    MESH, PICTURE, VIEW = sys.argv[1:] + [PICTURE, VIEW][len(sys.argv) - 2 :]

# %%
import laplacian_lines
import pymeshlab

try:
    laplacian_lines.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(MESH)
    view = meshes.generate_polyline_from_laplacian_lines(view=VIEW)
    laplacian_lines.picture(PICTURE, meshes.current_mesh(), view)
except (pymeshlab.PyMeshLabException, pymeshlab.InvalidEnumException, OSError, ValueError) as error:
    sys.exit(f"{MESH} cannot be drawn: {error}")
print(f"written: {PICTURE}")
