# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --picture: MeshLab with Laplacian lines switched on, on a picture, or several on a sheet: of meshes, from
several views, of several kinds of lines. The GUI driver does the clicking."""

import argparse
import os
import re
import typing

from environment.files import put_file
from environment.messages import Failure, say
from product.display import display, private_home
from product.meshlab import DRIVER_ERROR, LIMIT, loadable_mesh, explain_failure, loading, log_lines, run_meshlab, settings_commands
from product.sheet import make_sheet, escaped_label

LINE_SIDE = 900  # pixels of a picture's shorter side, above which lines get wider with it
VIEWS = {"front": "0,0", "right": "90,0", "back": "180,0", "left": "-90,0", "top": "0,90", "bottom": "0,-90"}
WARNING = "meshlab_driver: warning: "
NUMBER = r"[0-9]+(\.[0-9]+)?"


class Column(typing.NamedTuple):
    """A column of a sheet: its title, the driver's commands before a picture."""

    label: str
    before: str


def matching(pattern, what):
    """A type of argparse."""
    def take(text):
        if not re.fullmatch(pattern, text):
            raise argparse.ArgumentTypeError(f"it needs {what}")
        return text
    return take


def add_options(parser):
    """Options of pictures; their names."""
    size = matching("[1-9][0-9]*x[1-9][0-9]*", "WIDTHxHEIGHT, such as 1200x900")
    view = matching(rf"{'|'.join(VIEWS)}|-?{NUMBER},-?(0*[1-8]?[0-9](\.[0-9]+)?|0*90(\.0+)?)", f"one of {', '.join(VIEWS)}, or "
                    "AZIMUTH,ELEVATION in degrees, such as 30,15; the elevation is from -90 to 90")
    zoom = matching(r"0\.[1-9][0-9]*|[1-9](\.[0-9]+)?|10(\.0+)?", "a factor from 0.1 to 10")
    kinds = matching(".+", "names of kinds of lines with commas between, such as all or apparent_ridges,ridges+creases")
    added = [
        parser.add_argument("--size", type=size, default="1200x900", metavar="WxH", help="in pixels (1200x900); above 900, lines "
                            "get wider with the shorter side"),
        parser.add_argument("--view", type=view, default=[], action="append", help=f"from the {', '.join(VIEWS)}, or "
                            "AZIMUTH,ELEVATION, degrees to the right around the mesh and up, -90 to 90; once for each drawing"),
        parser.add_argument("--zoom", type=zoom, default="1", metavar="FACTOR", help="the middle of the drawing, larger "
                            "(0.1 to 10)"),
        parser.add_argument("--orthographic", action="store_true", help="without perspective"),
        parser.add_argument("--kinds", type=kinds, metavar="NAME,NAME...", help="a drawing on the sheet for each kind of lines, "
                            "such as all, usual, apparent_ridges, ridges+creases")]
    return [option.dest for option in added]


def check(condition, complaint):
    if not condition:
        raise Failure(complaint)


def picture_file(name):
    """A type of argparse."""
    folder = os.path.dirname(name) or "."
    for refused, why in ((not name.endswith(".png"), "it has to be a .png file"), (os.path.isdir(name), "it is a folder"),
                         (not (os.path.isdir(folder) and os.access(folder, os.W_OK)), "its folder cannot be written into")):
        if refused:
            raise argparse.ArgumentTypeError(f"{name}: {why}")
    return name


def columns_of(build, kinds):
    """Columns for kinds of lines by their names."""
    rows = [line.split("\t") for line in settings_commands(build, ["--kinds", kinds])] if kinds else [["", ""]]
    return [Column(*row) for row in rows]


class Pictures:
    """The drawings of a sheet, in files of a folder."""

    def __init__(self, stage, folder, options, columns, settings):
        self.stage, self.folder, self.options, self.columns, self.settings = stage, folder, options, columns, settings
        self.size = tuple(map(int, options.size.split("x")))
        self.views = options.view or [""]
        self.rows, self.failed = [], []  # pairs of file and name

    def take(self, picture, meshes):
        """Writes one picture, or a sheet of one per mesh, view and column. Meshes that fail are left out of the sheet,
        which then ends with an error."""
        target = os.path.join(os.path.realpath(os.path.dirname(picture) or "."), os.path.basename(picture))
        self.add_rows(meshes)
        # room for the window around the view and dialogs beside it
        with display(self.size[0] + 600, self.size[1] + 300):
            say(f"drawing {len(self.rows) * len(self.views) * len(self.columns)} times {self.options.size} in MeshLab")
            self.draw_rows()
        self.put_together(target)
        check(not self.failed, f"not drawn: {' '.join(self.failed)}")

    def add_rows(self, meshes):
        for number, mesh in enumerate(meshes):
            folder = self.folder / str(number)
            folder.mkdir()
            try:
                file = loadable_mesh(mesh, folder)
                self.rows.append((file, mesh or file.name))
            except Failure as reason:
                say(reason)
                self.failed.append(mesh)

    def drawing(self, row, view, column):
        """By the numbers of the three."""
        return self.folder / f"drawing_{row}_{view}_{column}.png"

    def row_script(self, number):
        """What stands between "together" and the end of its line is done before MeshLab redraws: each redraw of a large
        mesh takes its time. The style Publication looks the same, but what the user sets besides would not count. Kinds
        are compared as the core finds them."""
        options = self.options
        yield from loading(self.rows[number][0])
        yield f"size {options.size}"
        live = ["setdeco At Rest = Live Lines"] if options.kinds else []
        projection = "orthographic" if options.orthographic else "perspective"
        commands = ["draw-lines", "setdeco Surface = Paper", *live, *self.settings]
        for v, view in enumerate(self.views):
            angles = VIEWS.get(view or "front", view).replace(",", " ")
            commands.append(f"frame {angles} {options.up or 'y'} {options.zoom} {projection}")
            for c, column in enumerate(self.columns):
                commands += filter(None, (column.before, f"grab {self.drawing(number, v, c)}"))
        yield "together " + " ; ".join([*commands, "trigger Delete Current Mesh"])

    def script(self, first):
        """Draws the rows from the first-th on in one MeshLab, on white paper."""
        yield from (LIMIT, "wait", "check Show Layer Dialog on", "check Show Info Panel off", "check Show Trackball off",
                    f"size {self.options.size}", f"scale-lines {LINE_SIDE}", "wait-for-drawings")
        for number in range(first, len(self.rows)):
            yield from self.row_script(number)
        yield "quit"

    def draw_rows(self):
        """In as few MeshLabs as failures allow."""
        first = 0
        while first < len(self.rows):
            code = run_meshlab(self.stage, self.folder, self.script(first), env=private_home(self.folder / "home"))
            for line in dict.fromkeys(log_lines(self.folder)):
                if line.startswith(WARNING):
                    say(line.removeprefix(WARNING))
            undrawn = first
            while undrawn < len(self.rows) and self.drawing(undrawn, len(self.views) - 1, len(self.columns) - 1).exists():
                undrawn += 1
            # Earlier drawings may have brought it down: blame only a mesh that comes first.
            if undrawn < len(self.rows) and (code == DRIVER_ERROR or undrawn == first):
                name = self.rows[undrawn][1]
                say(f"{name}: {explain_failure(self.folder, code)}")
                self.failed.append(name)
                undrawn += 1
            first = undrawn

    def label(self, row, view, column):
        name, angles = os.path.basename(self.rows[row][1]).removesuffix(".gz"), self.views[view]
        if "," in angles:
            angles = angles.replace(",", "°, ") + "°"
        title = escaped_label(f"{name} {angles}".rstrip())
        return "\\n".join(filter(None, (title, self.columns[column].label)))

    def put_together(self, target):
        """The only drawing, or a sheet that keeps a drawing's kinds, or a mesh's views, together."""
        last = len(self.columns) - 1
        cells = [(self.label(row, view, column), self.drawing(row, view, column))
                 for row in range(len(self.rows)) for view in range(len(self.views))
                 if self.drawing(row, view, last).exists() for column in range(last + 1)]
        check(cells, "no picture was written")
        result = cells[0][1]
        if len(self.rows) + len(self.failed) > 1 or len(cells) > 1:
            result = self.folder / "sheet.png"
            make_sheet(result, self.size, last + 1 if last else len(self.views), cells)
        put_file(result, target)
        say(f"the picture is {target}")
