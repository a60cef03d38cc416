#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An animated picture of a mesh that turns about its upright axis, from one drawing at scale of all its views."""

import pathlib
import re
import tempfile
from xml.etree import ElementTree

from environment.build import build_folder, build_targets
from environment.files import put_file
from environment.messages import Failure, output, quietly, run_main, say
from environment.options import Parser
from product.models import check_mesh, prepare_mesh

COLUMNS = 4  # of views on a drawing, as kOthersInARow of view_cells.cpp
MARGIN = 2  # mm around what is drawn
GRAYS = 16
SVG = "{http://www.w3.org/2000/svg}"


def points_of(group):
    """Ends of the lines and curves of a view, mm on the page; all but the first of a path are relative."""
    points = []
    for path in group.iter(f"{SVG}path"):
        for command, text in re.findall(r"([Mlc])([^Mlcz]*)", path.get("d")):
            *_, x, y = map(float, re.findall(r"-?[0-9]*\.?[0-9]+", text))
            points.append((x, y) if command == "M" else (points[-1][0] + x, points[-1][1] + y))
    return points


def middle_and_half(values):
    return (min(values) + max(values)) / 2, (max(values) - min(values)) / 2


def cut_out(drawing, folder):
    """Files of the views alone, in their order. The axis is in the middle of each column: what is in it from one side is
    in it from the opposite side too."""
    root = ElementTree.parse(drawing).getroot()
    groups = [group for group in root.findall(f"{SVG}g") if group.find(f".//{SVG}path") is not None]
    views = [points_of(group) for group in groups]
    columns = [middle_and_half([x for view in views[column::COLUMNS] for x, _ in view]) for column in range(COLUMNS)]
    rows = [middle_and_half([y for _, y in view]) for view in views]
    width, height = (2 * (max(half for _, half in bands) + MARGIN) for bands in (columns, rows))
    for number, group in enumerate(groups):
        x, y = columns[number % COLUMNS][0] - width / 2, rows[number][0] - height / 2
        alone = ElementTree.Element(f"{SVG}svg", {"width": f"{width}mm", "height": f"{height}mm",
                                                  "viewBox": f"{x} {y} {width} {height}"})
        alone.append(group)
        file = folder / f"{number:03}.svg"
        ElementTree.ElementTree(alone).write(file)
        yield file


def draw(folder, mesh, options):
    step = 360 / options.frames  # from half of it on: views from the front and so on have other places
    views = ",".join(f"{step * (number + 0.5):.3f},0" for number in range(options.frames))
    drawing = folder / "views.svg"
    if not quietly(folder / "log", [build_folder() / "bin/laplacian-lines", drawing, "--views", views, "--paper", options.paper,
                                    "--annotations", "none", "--up", options.up, "--unit", "m", mesh]):
        raise Failure(f"{mesh} cannot be drawn")
    return drawing


def animate(file, drawings, options):
    frames = [drawing.with_suffix(".png") for drawing in drawings]
    for drawing, frame in zip(drawings, frames):
        if output("rsvg-convert", "--width", str(options.width), "--background-color", "white", "--output", frame, drawing) is None:
            raise Failure("rsvg-convert could not draw a view")
    if output("convert", *frames, "-colorspace", "Gray", "+dither", "-posterize", str(GRAYS), "-loop", "0", "-set", "delay",
              str(round(100 * options.seconds / options.frames)), "-layers", "Optimize", file) is None:
        raise Failure("ImageMagick could not put the frames together")


def parse():
    parser = Parser("scripts/turntable.py", description=__doc__)
    parser.add_argument("picture", metavar="FILE.gif")
    parser.add_argument("mesh", nargs="?", default="", metavar="MESH", help="PLY, OBJ, STL or OFF; without, the Stanford dragon")
    parser.add_argument("--up", choices=list("xyz"), default="y", help="the axis of the mesh that points upwards (y)")
    parser.add_argument("--frames", type=int, default=72, help=f"in a turn, a multiple of {2 * COLUMNS} (72)")
    parser.add_argument("--seconds", type=float, default=5.8, help="that a turn takes (5.8)")
    parser.add_argument("--width", type=int, default=720, help="in pixels (720)")
    parser.add_argument("--paper", default="a0", help="that all views fit on: what is small on it is left out (a0)")
    options = parser.parse_args()
    if options.frames % (2 * COLUMNS) or options.frames < 1:
        parser.error(f"--frames needs a multiple of {2 * COLUMNS}")
    return options


def main():
    options = parse()
    if options.mesh:
        check_mesh(options.mesh)
    build_targets("laplacian_lines_drawing", preset="product", extra_packages=["imagemagick", "librsvg2-bin"])
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        drawing = draw(folder, prepare_mesh(options.mesh, folder), options)
        say(f"putting {options.frames} views together")
        animate(folder / "turning.gif", list(cut_out(drawing, folder)), options)
        put_file(folder / "turning.gif", options.picture)


run_main(main)
