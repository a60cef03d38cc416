# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines in the plane of the picture are where a camera sees them, and are as wide and dark as their attributes say."""

import os
import pathlib
import resource
import signal
import tempfile
import warnings

import laplacian_lines
import matplotlib.figure
import numpy
from harness import meshes


def drawn(transform=False, **given):
    ms = meshes()
    if transform:
        ms.compute_matrix_from_translation_rotation_scale(translationx=2, rotationz=90, scalez=2, freeze=False)
    view = ms.generate_polyline_from_laplacian_lines(**given)
    return ms.current_mesh(), view, laplacian_lines.lines(ms.current_mesh(), view)


mesh, view, flat = drawn()
assert numpy.allclose(flat.points, mesh.vertex_matrix()[:, :2])  # from the front: x and y as they are
assert len(flat.edges) == mesh.edge_number()
mesh, view, flat = drawn(view="Right")
assert numpy.allclose(flat.points, mesh.vertex_matrix()[:, [2, 1]] * (-1, 1))  # z to the left, y up
mesh, view, flat = drawn(view="Top")
assert numpy.allclose(flat.points, mesh.vertex_matrix()[:, [0, 2]] * (1, -1))  # z downward
mesh, view, flat = drawn(transform=True)
assert numpy.allclose(flat.points, mesh.vertex_matrix()[:, [1, 0]] * (1, -1) + (2, 0))  # turned and moved

mesh, view, flat = drawn(viewpoint=[0, 0, 5])
points = mesh.vertex_matrix()
assert numpy.allclose(flat.points, points[:, :2] / (5 - points[:, 2:]), atol=1e-6)
# in the hole of the torus, half of which is behind the eye
warnings.simplefilter("ignore")  # which the filter rightly warns of
mesh, view, flat = drawn(viewpoint=[0.2, 0, 0.1], visible_only=False)
assert 0 < len(flat.edges) < 0.8 * mesh.edge_number() and numpy.isfinite(flat.points).all()
ahead = ((mesh.vertex_matrix() - view["viewpoint"]) @ -view["view_direction"])[flat.edges] > 0
assert ahead.all()

mesh, view, flat = drawn(light_direction=[1, 1, 1])
inside, outline = flat.kinds[flat.edges[:, 0]] == 0, flat.kinds[flat.edges[:, 0]] == 1
widths, strengths = flat.widths(), flat.strengths()
assert inside.any() and outline.any()
assert widths[inside].max() <= 1 and 1.25 < widths[outline].max() <= 1.3 + 1e-6
assert (0 <= strengths).all() and (strengths <= 1).all() and strengths.min() < 0.5 < strengths.max()

axes = matplotlib.figure.Figure().add_subplot()
collection = laplacian_lines.draw(axes, mesh, view, line_width=2, color="navy")
assert len(collection.get_segments()) == len(flat.edges)
assert numpy.isclose(max(collection.get_linewidths()), 2 * widths.max())
assert axes.get_aspect() == 1 and not axes.axison
darkest = numpy.array(collection.get_colors())[-1]
assert darkest[2] > darkest[0], "not drawn in the color"

# a picture that cannot be written leaves the one that was there
with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder, "lines.png")
    file.write_bytes(b"old")
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        laplacian_lines.picture(file, mesh, view)
        raise AssertionError("a picture was written without room for it")
    except OSError:
        pass
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert file.read_bytes() == b"old" and len(list(file.parent.iterdir())) == 1
    laplacian_lines.picture(file, mesh, view)
    assert file.read_bytes()[:4] == b"\x89PNG" and len(list(file.parent.iterdir())) == 1
    laplacian_lines.picture(pathlib.Path(folder, "lines"), mesh, view)
    assert pathlib.Path(folder, "lines.png").exists() and not pathlib.Path(folder, "lines").exists()
    odd = os.fsencode(folder) + b"/caf\xe9.png"
    laplacian_lines.picture(odd, mesh, view)
    assert os.path.getsize(odd) > 1000
    try:
        laplacian_lines.picture(folder + "/cut\0off.png", mesh, view)
        raise AssertionError("a name was cut")
    except ValueError as error:
        assert "null" in str(error), error
    assert not os.path.exists(folder + "/cut")
