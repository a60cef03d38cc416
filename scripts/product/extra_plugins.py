# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder from which MeshLab 2022.02 and later load plugins added by the user."""

import hashlib
import os
import pathlib
import re

from environment import packages
from environment.files import put_file
from environment.messages import Failure, output, say
from product.stage import installed_meshlab


def has_extra_plugins():
    return not packages.meshlab_version().startswith("2020.")


def expect_extra_plugins(folder):
    """`folder` is that of ./run --package, for all users."""
    if not has_extra_plugins():
        raise Failure(f"MeshLab {packages.meshlab_version()} loads no plugins from a user's folder; to have them for all users, "
                      f"run ./run --package and, as root, apt install {folder}/*.deb")


def user_data_folder():
    return pathlib.Path(os.environ.get("XDG_DATA_HOME") or os.path.join(os.environ["HOME"], ".local/share"))


def extra_plugins_folder():
    """MeshLab's folder is named after the first two parts of its version."""
    version = re.match(r"\d+\.\d+", packages.meshlab_version())[0]
    return user_data_folder() / "VCG/MeshLab_64bit_fp/MeshLabExtraPlugins" / version


def refuse_installed_plugins(plugins):
    """MeshLab would load plugins of the same name twice and stop at their parameters."""
    for plugin in plugins:
        installed = installed_meshlab() / "plugins" / plugin.name
        if installed.exists():
            owner = (output("dpkg-query", "--search", installed) or "").split(": ")[0]
            removal = f"apt remove {owner}" if owner else f"rm {installed}"
            raise Failure(f"{installed} is installed for all users and would be loaded twice; to install for you alone, first run: "
                          f"sudo {removal}")


def record_file():
    """What install_plugins() has made: one line each, "file CHECKSUM PATH" or "folder - PATH"."""
    return user_data_folder() / "laplacian-lines/installed"


def checksum(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def record():
    return record_file().read_text().splitlines() if record_file().exists() else []


def write_record(lines):
    put_file("".join(f"{line}\n" for line in lines).encode(), record_file())


def make_folders(folder):
    """Makes it and its missing parents; returns their lines for the record."""
    if folder.is_dir():
        return []
    made = make_folders(folder.parent)
    folder.mkdir()
    return [*made, f"folder - {folder}"]


def is_installed(file):
    """By install_plugins(), and unchanged since."""
    return f"file {checksum(file)} {file}" in record()


def install_plugins(plugins):
    """Into the user's own folder, replacing what was installed before. The record has old and new until all are
    there."""
    refuse_installed_plugins(plugins)
    folder = extra_plugins_folder()
    for target in (folder / plugin.name for plugin in plugins):
        if target.exists() and not is_installed(target):
            raise Failure(f"{target} already exists, but ./run has not installed it; remove it first")
    make_folders(record_file().parent)
    old = [line for line in record() if line.startswith("file ")]
    folders = [line for line in record() if line.startswith("folder ")] + make_folders(folder)
    new = [f"file {checksum(plugin)} {folder / plugin.name}" for plugin in plugins]
    write_record([*folders, *old, *new])
    for plugin in plugins:
        put_file(plugin, folder / plugin.name)
    remove_recorded(line for line in old if f" {folder}/" not in line)  # of another version of MeshLab
    write_record([*folders, *new])
    say(f"installed in {folder}; ./run --uninstall removes them")


def uninstall_plugins():
    if not record_file().exists():
        raise Failure("./run --install has installed nothing here")
    remove_recorded(reversed(record()))
    record_file().unlink()
    remove_if_empty(record_file().parent)


def remove_if_empty(folder):
    if folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()


def remove_recorded(lines):
    for line in lines:
        kind, _, path = line.split(" ", 2)
        path = pathlib.Path(path)
        if kind == "folder":
            remove_if_empty(path)
        elif path.exists() and is_installed(path):
            path.unlink()
            say(f"removed {path}")
        elif path.exists():
            say(f"left alone, because it is not what ./run has installed: {path}")
