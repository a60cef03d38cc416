# SPDX-License-Identifier: GPL-3.0-or-later
"""STAGE/bin/meshlab and meshlabserver: the installed MeshLab with our plugins beside its own. Writes nothing outside STAGE,
and replaces files as wholes: another MeshLab may just be starting there."""

import filecmp
import os
import pathlib
import shlex

from environment.files import locked, put_file
from environment.messages import output


def multiarch():
    return output("gcc", "-print-multiarch")


def installed_meshlab():
    return pathlib.Path(f"/usr/lib/{multiarch()}/meshlab")


def built_plugins(build, *folders):
    return [file for folder in folders for file in sorted((build / folder).glob("*.so"))]


def stage_meshlab(stage, plugins):
    """MeshLab looks for libraries, plugins and shaders in ../lib and ../share of its executable if that folder is called
    "bin". Qt follows links, so executables are copied."""
    installed, system = installed_meshlab(), stage / "system"
    libraries = system / "lib" / multiarch() / "meshlab"
    with locked(stage):
        for folder in (stage / "bin", system / "bin", system / "share"):
            folder.mkdir(parents=True, exist_ok=True)
        # MeshLab aborts where two plugins register the same parameters: ours come last and replace installed ones of the
        # same name
        link_all(libraries, installed.glob("*.so"))
        link_all(libraries / "plugins", [*installed.glob("plugins/*.so"), *plugins])
        link_all(system / "lib", [libraries])  # MeshLab built from its sources looks in lib/meshlab, Debian's in lib/ARCH
        link_all(system / "share", [pathlib.Path("/usr/share/meshlab")])
        for name in ("meshlab", "meshlabserver"):
            stage_program(stage, name)


def stage_program(stage, name):
    """What another version of MeshLab left goes."""
    program, copy = pathlib.Path("/usr/bin") / name, stage / "system/bin" / name
    if not program.exists():
        copy.unlink(missing_ok=True)
        (stage / "bin" / name).unlink(missing_ok=True)
        return
    # a running MeshLab may hold the old copy: replace it, do not write into it
    if not (copy.exists() and filecmp.cmp(program, copy, shallow=False)):
        put_file(program, copy, 0o755)
    write_start(stage, name)


def link_all(folder, files):
    """Links in the folder to these files; of equal names, the last one counts."""
    files = {file.name: file for file in files}
    folder.mkdir(parents=True, exist_ok=True)
    for link in folder.iterdir():
        if link.is_symlink() and link.name not in files:
            link.unlink()
    for name, file in files.items():
        link = folder / name
        if not (link.is_symlink() and link.exists() and link.samefile(file)):
            link.unlink(missing_ok=True)
            link.symlink_to(file)


def write_start(stage, name):
    """From 2022.02 on, MeshLab would also load the plugins that the user has added: give it another folder to look for
    them. Its OpenGL needs an X display, also on Wayland. Plugins that are compiled with sanitizers need their library,
    $SANITIZER_LIBRARY, in the program."""
    library = os.environ.get("SANITIZER_LIBRARY")
    data, program = (shlex.quote(str(stage / "system" / place)) for place in ("data", f"bin/{name}"))
    preload = f"export LD_PRELOAD={shlex.quote(library)}\n" if library else ""
    script = f'#!/bin/sh\n{preload}XDG_DATA_HOME={data} QT_QPA_PLATFORM=xcb exec {program} "$@"\n'
    put_file(os.fsencode(script), stage / "bin" / name, 0o755)
