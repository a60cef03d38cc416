# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./run does, by its command line."""

import argparse
import os

from environment import packages
from environment.build import build_folder, build_targets, ensure_toolchain
from environment.files import cache_folder
from environment.messages import Failure, say
from environment.options import Parser
from product import meshlabserver, picture, pymeshlab
from product.extra_plugins import expect_extra_plugins, has_extra_plugins, install_plugins, uninstall_plugins
from product.meshlab import is_project, open_window, settings_commands
from product.models import check_mesh
from product.package import make_packages
from product.portable import package_portable
from product.stage import built_plugins, stage_meshlab

ABOUT = """\
./run [MESH...] [PROJECT.mlp...]      opens MeshLab on them with Laplacian lines switched on, a layer each
./run --picture FILE.png [MESH...]    writes a drawing of MeshLab's view instead; of several meshes or views, a sheet,
                                      without those that fail
./run --drawing FILE.svg|.pdf|.dxf|.png [OPTIONS] [MESH...]
./run --drawing FOLDER/ [OPTIONS] MESH...
                                      writes a measured drawing: views at scale on paper; of several meshes, or folders
                                      of them, one of all in a FILE, or one each and a contact sheet in a FOLDER/;
                                      --drawing --help has the options
"""
MORE = f"""\
MESH is any file that MeshLab reads, also gzipped; without one, the Stanford dragon is fetched by npm. Without a display,
./run alone writes the picture laplacian_lines.png. Whatever else is missing (MeshLab, compiler, libraries) is installed
with apt-get; downloads are kept in {cache_folder()}.
"""


def setting(text):
    if "=" not in text:
        raise argparse.ArgumentTypeError('it needs NAME=VALUE, such as Detail=70 or "Line Color=navy"')
    return text


def make_parser():
    """With the names of the options that only pictures have."""
    parser = Parser("./run", description=ABOUT, epilog=MORE, usage="./run [OPTIONS] [MESH...]")
    parser.add_argument("meshes", nargs="*", metavar="MESH", help=argparse.SUPPRESS)
    parser.add_argument("--set", action="append", type=setting, default=[], metavar="NAME=VALUE", help="any parameter of the "
                        'lines, for this window or picture, such as Detail=70 or "Line Color=navy"; a wrong NAME lists all')
    parser.add_argument("--up", choices=list("xyz"), help="the axis of the mesh that points upwards in the first view, or in "
                        "the picture; otherwise y, in a window z if the mesh is 1.3 times as high along it as wide")
    modes = parser.add_argument_group("what to do instead").add_mutually_exclusive_group()
    modes.add_argument("--picture", metavar="FILE.png", type=picture.picture_file, help="writes a drawing of MeshLab's view")
    modes.add_argument("--server", nargs=argparse.REMAINDER, metavar="ARGS", help="runs meshlabserver ARGS..., or PyMeshLab in "
                       "its place, with the filters")
    modes.add_argument("--python", nargs=argparse.REMAINDER, metavar="ARGS", help="runs Python ARGS... with PyMeshLab and the "
                       "module laplacian_lines")
    modes.add_argument("--install", action="store_true", help="adds the plugins to the user's own (MeshLab 2022.02 and later; "
                       "for the others, --package)")
    modes.add_argument("--uninstall", action="store_true", help="removes what --install has added")
    modes.add_argument("--package", action="store_true", help="makes a .deb and a .zip of the plugins, for the MeshLab "
                       "installed here")
    parser.add_argument("--portable", action="store_true", help="with --package, makes a .zip for MeshLab 2025.07 as its "
                        "authors publish it, on any Linux")
    return parser, picture.add_options(parser.add_argument_group("of pictures"))


def parse(words):
    """The options, if they go together; without a display a picture is asked for."""
    parser, of_pictures = make_parser()
    options = parser.parse_intermixed_args(words)
    others = [name for name in ("server", "python", "install", "uninstall", "package", "portable")
              if getattr(options, name) not in (None, False)]
    if others and (options.meshes or options.set or options.up):
        raise Failure(f"--{others[0]} takes neither meshes nor --set nor --up")
    for mesh in options.meshes:
        check_mesh(mesh)
    if not others and not options.picture and not os.environ.get("DISPLAY"):
        options.picture = "laplacian_lines.png"
        say(f"no display: writing the picture {options.picture} instead of opening a window")
    projects = [mesh for mesh in options.meshes if is_project(mesh)]
    if options.picture and projects:
        raise Failure(f"a project opens in a window; for a picture, name its meshes instead of {projects[0]}")
    given = [name for name in of_pictures if getattr(options, name) != parser.get_default(name)]
    if given and not options.picture:
        raise Failure(f"--{given[0]} goes with --picture")
    return options


def build_and_stage(target, *extra_packages):
    """The stage."""
    build_targets(target, preset="window", extra_packages=extra_packages)
    stage = build_folder() / "stage"
    stage_meshlab(stage, built_plugins(build_folder(), "plugins", "driver"))
    return stage


def show(options, work):
    """In a window or a picture."""
    build, meshes = build_folder(), options.meshes or [""]
    if not options.picture:
        stage = build_and_stage("meshlab_plugins")
        return open_window(stage, work, meshes, settings_commands(build, options.set), options.up)
    is_sheet = options.kinds or len(meshes) > 1 or len(options.view) > 1
    stage = build_and_stage("picture_plugins", *packages.DISPLAY, *(["imagemagick"] if is_sheet else []))
    columns = picture.columns_of(build, options.kinds)
    return picture.Pictures(stage, work, options, columns, settings_commands(build, options.set)).take(options.picture, meshes)


def run_command(words, work):
    """The exit code, None for 0; the folder is for temporary files."""
    options, build = parse(words), build_folder()
    if options.server is not None:
        packages.ensure_packages("meshlab")
        if has_extra_plugins():  # of a version without meshlabserver
            return pymeshlab.run_server(options.server)
        return meshlabserver.run_server(build_and_stage("meshlab_plugins"), options.server, work)
    if options.python is not None:
        return pymeshlab.run_python(options.python)
    if options.install:
        packages.ensure_packages("meshlab")
        expect_extra_plugins(build / "packages")
        build_targets("meshlab_plugins", preset="product", extra_packages=())
        return install_plugins(built_plugins(build, "plugins"))
    if options.uninstall:
        return uninstall_plugins()
    if options.portable:
        ensure_toolchain(*packages.PACKAGING)
        return package_portable()
    if options.package:
        build_targets("meshlab_plugins", "laplacian_lines_drawing", preset="product", extra_packages=packages.PACKAGING)
        return make_packages(build, build / "packages")
    return show(options, work)
