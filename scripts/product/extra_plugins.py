# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder from which MeshLab 2022.02 and later load plugins added by the user."""

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


def record_file():
    """The files that install_plugins() has made, one a line."""
    return user_data_folder() / "laplacian-lines/installed"


def recorded():
    """The files; former versions had their checksums before them."""
    lines = record_file().read_text().splitlines() if record_file().exists() else []
    return [pathlib.Path(re.sub(r"^file \S+ ", "", line)) for line in lines if not line.startswith("folder ")]


def refuse_installed_plugins(plugins):
    """MeshLab would load plugins of the same name twice and stop at their parameters."""
    for plugin in plugins:
        installed = installed_meshlab() / "plugins" / plugin.name
        if installed.exists():
            owner = (output("dpkg-query", "--search", installed) or "").split(": ")[0]
            removal = f"apt remove {owner}" if owner else f"rm {installed}"
            raise Failure(f"{installed} is installed for all users and would be loaded twice; to install for you alone, first run: "
                          f"sudo {removal}")


def install_plugins(plugins):
    """Into the user's own folder, replacing what was installed before, also for another version of MeshLab."""
    refuse_installed_plugins(plugins)
    folder, old = extra_plugins_folder(), recorded()
    new = [folder / plugin.name for plugin in plugins]
    for target in new:
        if target.exists() and target not in old:
            raise Failure(f"{target} already exists, but ./run has not installed it; remove it first")
    for place in (folder, record_file().parent):
        place.mkdir(parents=True, exist_ok=True)
    put_file("".join(f"{file}\n" for file in dict.fromkeys([*old, *new])).encode(), record_file())
    for plugin in plugins:
        put_file(plugin, folder / plugin.name)
    remove([file for file in old if file not in new])
    put_file("".join(f"{file}\n" for file in new).encode(), record_file())
    say(f"installed in {folder}; ./run --uninstall removes them")


def uninstall_plugins():
    if not record_file().exists():
        raise Failure("./run --install has installed nothing here")
    remove([*recorded(), record_file()])


def remove(files):
    """With the folders that are empty then."""
    for file in files:
        file.unlink(missing_ok=True)
        say(f"removed {file}")
        for folder in file.parents:
            if folder == user_data_folder() or not folder.is_dir() or any(folder.iterdir()):
                break
            folder.rmdir()
