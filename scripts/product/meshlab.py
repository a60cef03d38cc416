# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab, told by a script of the GUI driver what to do with the user's meshes and projects."""

import contextlib
import locale
import os
import re
import subprocess

from environment.messages import Failure, run, say
from product.models import prepare_mesh

MINUTES = 15  # more than a mesh of ten million triangles takes to load and prepare
LIMIT = f"time-limit {MINUTES * 60}"
STILL = 120  # seconds without progress after which a reader of MeshLab's is taken to hang
DRIVER_ERROR = 3  # the exit code of MeshLab when the driver ends it


def needs_other_name(name):
    """Whether a name cannot be written in a line of the driver, which is UTF-8, or in the user's locale, as MeshLab has
    names."""
    with contextlib.suppress(locale.Error):
        locale.setlocale(locale.LC_CTYPE, "")
    return not name.isprintable() or not (name.isascii() or locale.nl_langinfo(locale.CODESET) == "UTF-8")


def loadable_mesh(name, folder):
    """As prepare_mesh(), but a link with another name if needed."""
    mesh = prepare_mesh(name, folder)
    if not needs_other_name(str(mesh)):
        return mesh
    link = folder / f"mesh{mesh.suffix}"
    link.symlink_to(mesh)
    return link


def settings_commands(build, settings):
    """The driver's commands for parameters of the decoration, NAME=VALUE, from a program built on the decoration's
    table; or, after --kinds, a line per kind: its label, a tab, commands."""
    done = subprocess.run([build / "bin/decoration_settings", *settings], capture_output=True)
    if done.returncode != 0:
        raise Failure(os.fsdecode(done.stderr).rstrip("\n"))
    return os.fsdecode(done.stdout).splitlines()


def run_meshlab(stage, folder, lines, env=os.environ):
    """MeshLab's exit code after this driver script; its output goes to FOLDER/log."""
    (folder / "script").write_text("".join(f"{line}\n" for line in lines), encoding="utf-8", errors="surrogateescape")
    environment = {**env, "LAPLACIAN_LINES_DRIVER": str(folder / "script")}
    with (folder / "log").open("wb") as log:
        return run([stage / "bin/meshlab"], stdout=log, stderr=log, env=environment)


def loading(file):
    """The driver's commands that load a mesh."""
    return [f"time-limit {STILL}", f"load {file}", LIMIT]


def log_lines(folder):
    return (folder / "log").read_text(errors="surrogateescape").splitlines()


def explain_failure(folder, code):
    """Why MeshLab ended, in a line."""
    log = "\n".join(log_lines(folder))
    if found := re.search(r"^meshlab_driver: error: line \d+: load .*\.(.*): time-out", log, re.M):
        return f"the reader of .{found[1]} files was ended, without progress for {STILL} s; the file may be damaged"
    for kind in ("reason", "error"):
        if found := re.findall(f"^meshlab_driver: {kind}: (.*)$", log, re.M):
            return found[-1]
    doing = re.findall(r"^meshlab_driver: line \d+: (.*)$", log, re.M)
    if doing and doing[-1].startswith("load "):
        return f"the reader of .{doing[-1].rsplit('.', 1)[-1]} files crashed MeshLab (exit code {code}); the file may be damaged"
    return f"MeshLab ended with code {code}; its last output: {log.splitlines()[-1] if log else ''}"


def is_project(name):
    return name.lower().endswith((".mlp", ".mlb", ".aln"))


def opening(name, folder):
    """The driver's commands that open a mesh, a project or, without a name, the dragon."""
    if is_project(name):
        project = os.path.realpath(name)  # no link elsewhere: the names in it are of files beside it
        if needs_other_name(project):
            raise Failure(f"MeshLab cannot open a project of this name, {name}: rename it or its folder")
        return [f"open-project {project}"]
    folder.mkdir(parents=True)
    return loading(loadable_mesh(name, folder))


def framing(names, up):
    """The driver's commands that turn the first view, which has y up. Projects have views of their own."""
    if up:
        return [f"frame-upright {up}"]
    return [] if any(map(is_project, names)) else ["frame-upright"]


def open_window(stage, folder, names, settings=(), up=None):
    """Meshes and projects in one window, with the axis `up` upwards, or else the one that is likely to be. MeshLab only
    keeps its dialogs' settings if told to."""
    # a project after other layers opens in a document of its own, and lines are switched on in the one shown
    openings = [line for number, name in enumerate(names)
                for line in (*opening(name, folder / str(number)), "draw-all-lines")]
    say("opening MeshLab; Laplacian Lines is under Render")
    code = run_meshlab(stage, folder, [LIMIT, "wait", *openings, "open-parameters", *framing(names, up), *settings])
    if code != 0:
        done = re.findall(r"^meshlab_driver: line \d+: (.*)$", "\n".join(log_lines(folder)), re.M)
        opened = re.fullmatch("(?:load|open-project) (.*)", done[-1]) if done else None
        raise Failure((f"{opened[1]}: " if opened else "") + explain_failure(folder, code))
