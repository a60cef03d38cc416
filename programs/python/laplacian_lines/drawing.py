# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat drawings of the lines that the polyline filter makes, as they are seen from its view."""

import io
import os
import pathlib
import typing

import numpy

from .tables import KINDS
from .whole_file import write_whole


class Lines(typing.NamedTuple):
    """Lines in the plane of the picture. `points` and what follows it have an entry for each vertex."""

    edges: numpy.ndarray  # (edges, 2), numbers of vertices
    points: numpy.ndarray  # (vertices, 2), x to the right, y up; in the mesh's unit, or slopes in perspective
    kinds: numpy.ndarray  # numbers in tables.KINDS
    weights: numpy.ndarray  # share of the full width, 0 to 1
    opacities: numpy.ndarray  # 0 to 1

    def widths(self):
        """Of each edge, in widths of a Laplacian line at its strongest: outlines are bolder."""
        factors = numpy.array([kind.width for kind in KINDS])
        return self._of_edges(self.weights) * factors[self.kinds[self.edges[:, 0]]]

    def strengths(self):
        """How dark each edge is, 0 to 1."""
        return self._of_edges(self.opacities)

    def _of_edges(self, values):
        return values[self.edges].mean(axis=1)


def lines(mesh, view):
    """The layer that the polyline filter has made, in the plane of its picture.

    `mesh` is that layer, a pymeshlab.Mesh; `view` what the filter returned: a dictionary with "view_direction" (to the
    viewer) and "up" and, in perspective, "viewpoint", in world coordinates.
    """
    points = mesh.vertex_matrix()
    world = points @ mesh.transform_matrix()[:3, :3].T + mesh.transform_matrix()[:3, 3]
    back = numpy.asarray(view["view_direction"], dtype=float)
    back = back / numpy.linalg.norm(back)
    right = numpy.cross(view["up"], back)
    right /= numpy.linalg.norm(right)
    axes = numpy.stack([right, numpy.cross(back, right)])
    edges = mesh.edge_matrix()
    if "viewpoint" in view:
        rays = world - view["viewpoint"]
        depths = -rays @ back
        in_front = depths > 1e-3 * numpy.abs(depths).max(initial=0)
        edges = edges[in_front[edges].all(axis=1)]
        flat = rays @ axes.T / numpy.where(in_front, depths, 1)[:, None]
    else:
        flat = world @ axes.T
    return Lines(edges, flat, mesh.vertex_custom_scalar_attribute_array("ll_kind").astype(int),
                 mesh.vertex_custom_scalar_attribute_array("ll_weight"),
                 mesh.vertex_custom_scalar_attribute_array("ll_opacity"))


def draw(axes, mesh, view, line_width=1.2, color="black"):
    """Draws the lines of a layer, see lines(), on Matplotlib's axes: to scale, without a frame.

    `line_width` is that of a Laplacian line at its strongest, in points (1/72 inch). Faint lines are paler instead of
    transparent, so that nothing shows through where pieces of a line meet. Returns the LineCollection.
    """
    return _draw(axes, lines(mesh, view), line_width, color)


def _draw(axes, flat, line_width=1.2, color="black"):
    from matplotlib.collections import LineCollection
    from matplotlib.colors import to_rgb

    strengths = flat.strengths()
    order = numpy.argsort(strengths, kind="stable")  # no pale piece covers a dark one
    ink, paper = (numpy.array(to_rgb(c)) for c in (color, axes.get_figure().get_facecolor()))
    colors = paper + strengths[order, None] * (ink - paper)
    collection = LineCollection(flat.points[flat.edges[order]], linewidths=line_width * flat.widths()[order],
                                colors=colors, capstyle="round")
    axes.add_collection(collection)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()
    return collection


def picture(file, mesh, view, size=8, dpi=150, **style):
    """Writes a picture of the lines of a layer, see draw() for `style`: PNG, SVG or PDF by the ending of the name.

    `size` of the longer side is in inches; `dpi` is the number of pixels of one. Needs no display.
    """
    from matplotlib.figure import Figure

    flat = lines(mesh, view)
    used = flat.points[numpy.unique(flat.edges)]
    extent = numpy.ptp(used, axis=0) if len(used) else numpy.ones(2)
    sides = numpy.maximum(size * extent / max(extent.max(), 1e-30), 0.2 * size)
    figure = Figure(figsize=sides, dpi=dpi)
    _draw(figure.add_axes([0.02, 0.02, 0.96, 0.96]), flat, **style)
    place = pathlib.Path(os.fsdecode(file))
    place = place if place.suffix else place.with_suffix(".png")
    content = io.BytesIO()
    figure.savefig(content, format=place.suffix[1:])
    write_whole(place, content.getvalue())
