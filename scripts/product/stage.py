# SPDX-License-Identifier: GPL-3.0-or-later
"""STAGE/bin/meshlab and meshlabserver: the installed MeshLab with our plugins beside its own; writes nothing outside
STAGE and leaves alone what is right: another MeshLab may just be starting there."""

import filecmp
import os
import pathlib
import shlex
import subprocess

from environment.files import put_file, turn
from environment.messages import exit_code, output, say


def multiarch():
    return output("dpkg-architecture", "-qDEB_HOST_MULTIARCH") or output("gcc", "-print-multiarch")


def installed_meshlab():
    return pathlib.Path(f"/usr/lib/{multiarch()}/meshlab")


def built_plugins(build, *folders):
    return [file for folder in folders for file in sorted((build / folder).glob("*.so"))]


def stage_meshlab(stage, plugins):
    with turn(stage):
        (stage / "bin").mkdir(exist_ok=True)
        copy_meshlab(stage / "system", plugins)
        stage_program(stage, "meshlab")
        if os.path.exists("/usr/bin/meshlabserver"):
            stage_program(stage, "meshlabserver")
        else:  # our own program of the same arguments
            filters = [word for plugin in plugins if plugin.name.startswith("libfilter_")
                       for word in ("--plugin", str(plugin))]
            words = shlex.join([str(stage.parent / "bin/laplacian_lines_server"), *filters])
            write_program(f'exec {words} "$@"', stage / "bin/meshlabserver")


def copy_meshlab(folder, plugins):
    """MeshLab looks beside its executable for libraries, plugins and shaders if that folder is called "bin". Qt follows
    links, so executables are copied."""
    installed = installed_meshlab()
    libraries = folder / "lib" / multiarch() / "meshlab"
    for name in ("bin", "share"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for name in ("meshlab", "meshlabserver"):
        program, copy = pathlib.Path("/usr/bin", name), folder / "bin" / name
        # a running MeshLab may hold the old copy: replace it, do not write into it
        if program.exists() and not (copy.exists() and filecmp.cmp(program, copy, shallow=False)):
            put_file(program, copy, 0o755)
    link_all(libraries, installed.glob("*.so"))
    # MeshLab stops at parameters of two plugins with the same decorations: ours replaces an installed one of the same
    # name
    link_all(libraries / "plugins", [*installed.glob("plugins/*.so"), *plugins])
    link_all(folder / "lib", [libraries])  # where MeshLab looks that was not built by a distribution
    link_all(folder / "share", [pathlib.Path("/usr/share/meshlab")])


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


def stage_program(stage, name):
    """From 2022.02 on, MeshLab would also load the plugins that the user has added: give it another folder to look for
    them. Its OpenGL needs an X display, also on Wayland. Plugins that are compiled with sanitizers need their library,
    $SANITIZER_LIBRARY, in the program."""
    library = os.environ.get("SANITIZER_LIBRARY")
    data, program = (shlex.quote(str(stage / "system" / place)) for place in ("data", f"bin/{name}"))
    preload = f"export LD_PRELOAD={library}\n" if library else ""
    write_program(f'{preload}XDG_DATA_HOME={data} QT_QPA_PLATFORM=xcb exec {program} "$@"', stage / "bin" / name)


def write_program(commands, file):
    put_file(os.fsencode(f"#!/bin/sh\n{commands}\n"), file, 0o755)


def words_after(option, words):
    """The words up to the next option."""
    result, reading = [], False
    for word in words:
        if word.startswith("-"):
            reading = word == option
        elif reading:
            result.append(word)
    return result


def outputs_are_there(begun, words):
    """MeshLab 2020.09's meshlabserver ends with 0 even if it cannot write: names outputs older than the file `begun`,
    or missing."""
    names = [name for option, name in zip(words, words[1:]) if option == "-o"]
    missing = [name for name in names if not os.path.exists(name)
               or os.stat(name).st_mtime_ns <= begun.stat().st_mtime_ns]
    for name in missing:
        say(f"{name} was not written")
    return not missing


def blame_reader(server, words):
    """MeshLab 2020.09's meshlabserver died by a signal, which loses its output: says which mesh does that on its
    own."""
    for mesh in words_after("-i", words):
        done = subprocess.run([server, "-i", mesh], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if is_signal(exit_code(done.returncode)):
            say(f"{mesh}: MeshLab's own reader of .{mesh.rsplit('.')[-1]} files crashes meshlabserver; the file may be damaged")


def is_signal(code):
    return 128 < code < 192  # 255 is meshlabserver's own
