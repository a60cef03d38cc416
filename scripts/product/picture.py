# SPDX-License-Identifier: GPL-3.0-or-later
"""./run --picture: MeshLab with Laplacian lines switched on, on a picture, or several on a sheet: of meshes, from
several views, of several kinds of lines, and of edges that are found in pictures of the shaded surface. The GUI driver
does the clicking."""

import dataclasses
import math
import os
import pathlib
import re
import subprocess
import typing

from environment.files import put_file
from environment.messages import Failure, Obstacle, say
from environment.python_environments import ensure_python
from product.display import display, private_home
from product.meshlab import DRIVER_ERROR, LIMIT, drivable_mesh, explain_failure, loading, log_lines, run_meshlab
from product.sheet import make_sheet, plain_label

NOISE_SEED = 1
LINE_SIDE = 900  # pixels of a picture's shorter side, above which lines get wider with it
LINE_WIDTH = 1.6  # pixels, as in the decoration's table
VIEWS = {"front": "0,0", "right": "90,0", "back": "180,0", "left": "-90,0", "top": "0,90", "bottom": "0,-90"}
IMAGE_TOOLS = ("scikit-image==0.25.2", "numpy==2.2.6", "scipy==1.15.3", "pillow==11.3.0")
WARNING = "meshlab_driver: warning: "
NUMBER = r"[0-9]+(\.[0-9]+)?"


@dataclasses.dataclass
class Column:
    """A column of a sheet: its title, an edge detector or -, the driver's commands before and after a picture."""

    label: str = ""
    detector: str = "-"
    before: str = ""
    after: str = ""

    def has_edges(self):
        return self.detector != "-"


@dataclasses.dataclass
class Row:
    """A mesh for MeshLab to draw, and how far to move its vertices, "" for not at all."""

    file: pathlib.Path
    name: str
    noise: str = ""

    def full_name(self):
        return self.name + (", with noise" if self.noise else "")


@dataclasses.dataclass
class Options:
    """What the options of a picture say."""

    size: tuple = (1200, 900)
    views: list = dataclasses.field(default_factory=list)
    up: str = "y"
    zoom: str = "1"
    projection: str = "perspective"
    kinds: str = ""
    noise: str = ""

    OPTIONS: typing.ClassVar = ("--size", "--view", "--up", "--zoom", "--orthographic", "--kinds", "--noise")

    def take(self, words):
        """Takes an option from the beginning of the words."""
        option = words.pop(0)
        if option == "--orthographic":
            self.projection = "orthographic"
            return
        value = words.pop(0) if words else ""
        if option == "--size":
            check(re.fullmatch("[1-9][0-9]*x[1-9][0-9]*", value), "--size needs WIDTHxHEIGHT, such as 1200x900")
            self.size = tuple(map(int, value.split("x")))
        elif option == "--view":
            check(value in VIEWS or re.fullmatch(rf"-?{NUMBER},-?(0*[1-8]?[0-9](\.[0-9]+)?|0*90(\.0+)?)", value),
                  "--view needs front, back, left, right, top or bottom, or AZIMUTH,ELEVATION in degrees, such as 30,15; the elevation is "
                  "from -90 to 90")
            self.views.append(value)
        elif option == "--up":
            check(value in ("x", "y", "z"), "--up needs the axis that points upwards: x, y or z")
            self.up = value
        elif option == "--zoom":
            check(re.fullmatch(NUMBER, value) and 0.1 <= float(value) <= 10, "--zoom needs a factor from 0.1 to 10")
            self.zoom = value
        elif option == "--kinds":
            check(value and value[0] != "-",
                  "--kinds needs names of kinds of lines with commas between, such as all or apparent_ridges,valleys")
            self.kinds = value
        else:
            check(re.fullmatch(NUMBER, value) and 0 < float(value) <= 2,
                  "--noise needs a share of the mean edge, above 0 and up to 2")
            self.noise = value


def check(condition, complaint):
    if not condition:
        raise Failure(complaint)


def check_picture(name):
    check(name.endswith(".png"), f"the picture has to be a .png file, not {name}")
    check(not os.path.isdir(name), f"the picture cannot be {name}, which is a folder")
    folder = os.path.dirname(name) or "."
    check(os.path.isdir(folder) and os.access(folder, os.W_OK), f"cannot write into the folder of {name}")


def columns_of(build, kinds, settings=()):
    """Columns for kinds of lines by their names, with the user's settings, from a program built on the decoration's
    table."""
    if not kinds:
        return [Column()]
    done = subprocess.run([build / "bin/decoration_settings", "--kinds", kinds, *settings], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    table = os.fsdecode(done.stdout).rstrip("\n")
    check(done.returncode == 0, f"--kinds: {table}")
    return [Column(*line.split("\t")) for line in table.split("\n")]


def image_python():
    """A Python that finds edges in pictures."""
    try:
        return ensure_python("image_tools", 1, "0.3 GB", *IMAGE_TOOLS)
    except Obstacle as reason:
        raise Failure(f"there are no edges of pictures (log, canny): {reason}") from None


class Pictures:
    """The drawings of a sheet, in files of a folder."""

    def __init__(self, stage, folder, options, columns=None, settings=()):
        self.stage, self.folder, self.options = stage, folder, options
        self.columns, self.settings = columns or [Column()], settings
        self.views = options.views or [""]
        self.rows, self.failed = [], []
        self.python = image_python() if any(map(Column.has_edges, self.columns)) else None

    def take(self, picture, meshes):
        """Writes one picture, or a sheet of one per mesh, view and column. Meshes that fail are left out of the sheet,
        which then ends with an error."""
        target = os.path.join(os.path.realpath(os.path.dirname(picture) or "."), os.path.basename(picture))
        self.add_rows(meshes)
        width, height = self.options.size
        # room for the window around the view and dialogs beside it
        with display(width + 600, height + 300):
            say(f"drawing {len(self.rows) * len(self.views) * len(self.columns)} times {width}x{height} in MeshLab")
            self.draw_rows()
        self.put_together(target)
        check(not self.failed, f"not drawn: {' '.join(self.failed)}")

    def add_rows(self, meshes):
        for number, mesh in enumerate(meshes):
            folder = self.folder / str(number)
            folder.mkdir()
            try:
                file = drivable_mesh(mesh, folder)
            except Failure as reason:
                say(reason)
                self.failed.append(mesh)
                continue
            self.rows += [Row(file, mesh or file.name, noise) for noise in dict.fromkeys(("", self.options.noise))]

    def drawing(self, row, view, column):
        """By the numbers of the three."""
        return self.folder / f"drawing_{row}_{view}_{column}.png"

    def kernel_file(self, row, view):
        """Takes the size of the kernel in the drawing."""
        return self.folder / f"kernel_{row}_{view}"

    def row_script(self, number):
        """What stands between "together" and the end of its line is done before MeshLab redraws: each redraw of a large
        mesh takes its time. The style Publication looks the same, but what the user sets besides would not count. Lines
        show what is large enough for the picture, while kinds are compared at one kernel."""
        row, options = self.rows[number], self.options
        yield from loading(row.file)
        if row.noise:
            noisy = self.folder / f"noisy_{number}.ply"
            yield from (f'write-noisy {row.noise} {NOISE_SEED} "{noisy}"', "trigger Delete Current Mesh",
                        f"load {noisy}")
        yield f"size {options.size[0]}x{options.size[1]}"
        scale = [] if options.kinds else ["setdeco Scale = With the View"]
        commands = ["draw-lines", "setdeco Surface = Paper", "setdeco Background = Paper Color", *scale, *self.settings]
        for v, view in enumerate(self.views):
            angles = VIEWS.get(view or "front", view).replace(",", " ")
            commands.append(f"frame {angles} {options.up} {options.zoom} {options.projection}")
            if self.python:
                commands.append(f"write-kernel {self.kernel_file(number, v)}")
            for c, column in enumerate(self.columns):
                commands += filter(None, (column.before, f"grab {self.drawing(number, v, c)}", column.after))
        yield "together " + " ; ".join([*commands, "trigger Delete Current Mesh"])

    def script(self, first):
        """Draws the rows from the first-th on in one MeshLab, on white paper."""
        yield from (LIMIT, "wait", "check Show Layer Dialog on", "check Show Info Panel off",
                    "check Show Trackball off",
                    f"size {self.options.size[0]}x{self.options.size[1]}", f"scale-lines {LINE_SIDE}",
                    "wait-for-levels")
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
            while undrawn < len(self.rows) and self.drawing(undrawn, len(self.views) - 1,
                                                            len(self.columns) - 1).exists():
                undrawn += 1
            # Earlier drawings may have brought it down: blame only a mesh that comes first.
            if undrawn < len(self.rows) and (code == DRIVER_ERROR or undrawn == first):
                name = self.rows[undrawn].full_name()
                say(f"{name}: {explain_failure(self.folder, code)}")
                self.failed.append(name)
                undrawn += 1
            first = undrawn

    def blur(self, row, view):
        """The kernel's standard deviation, from its size in pixels: exp(-r² / 4h) has the square root of 2h."""
        return f"{math.sqrt(2) * float(self.kernel_file(row, view).read_text()):.1f}"

    def label(self, row, view, column):
        name, angles = self.rows[row].name.removesuffix(".gz"), self.views[view]
        if "," in angles:
            angles = angles.replace(",", "°, ") + "°"
        parts = [plain_label(os.path.basename(name)) + (f" {angles}" if angles else "")]
        if self.rows[row].noise:
            parts[0] += f", noise of {self.rows[row].noise} mean edges, seed {NOISE_SEED}"
        if self.columns[column].label:
            parts.append(self.columns[column].label)
        if self.columns[column].has_edges():
            parts[-1] += f", σ = {self.blur(row, view)} px"
        return "\\n".join(parts)

    def find_edges(self, row, view, column):
        """Replaces the picture by its edges, with wider lines where those of surfaces are."""
        picture = self.drawing(row, view, column)
        part = picture.with_suffix(".part.png")
        width = LINE_WIDTH * max(1, min(self.options.size) / LINE_SIDE)
        tool = pathlib.Path(__file__).with_name("picture_edges.py")
        done = subprocess.run([self.python, "-B", tool, self.columns[column].detector, self.blur(row, view),
                               f"{width:g}", picture, part])
        check(done.returncode == 0, "the edges of the picture could not be found")
        part.rename(picture)

    def put_together(self, target):
        """The only drawing, or a sheet that keeps a drawing's kinds, or a mesh's views, together."""
        cells = []
        numbers = range(len(self.columns))
        for row, view in ((row, view) for row in range(len(self.rows)) for view in range(len(self.views))):
            if all(self.drawing(row, view, column).exists() for column in numbers):
                for column in numbers:
                    if self.columns[column].has_edges():
                        self.find_edges(row, view, column)
                    cells.append((self.label(row, view, column), self.drawing(row, view, column)))
        check(cells, "no picture was written")
        if len(self.rows) + len(self.failed) == 1 and len(cells) == 1:
            put_file(cells[0][1], target)
        else:
            sheet = self.folder / "sheet.png"
            make_sheet(sheet, self.options.size, len(self.columns) if len(self.columns) > 1 else len(self.views), cells)
            put_file(sheet, target)
        say(f"the picture is {target}")
