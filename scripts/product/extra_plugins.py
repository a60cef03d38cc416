# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder from which MeshLab 2022.02 and later load plugins added by the user; ours are recognized by name."""

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


def all_extra_plugins():
    """The folder of those of all versions of MeshLab."""
    data = os.environ.get("XDG_DATA_HOME") or os.path.join(os.environ["HOME"], ".local/share")
    return pathlib.Path(data, "VCG/MeshLab_64bit_fp/MeshLabExtraPlugins")


def extra_plugins_folder():
    """Named after the first two parts of its version."""
    return all_extra_plugins() / re.match(r"\d+\.\d+", packages.meshlab_version())[0]


def refuse_installed_plugins(plugins):
    """MeshLab would load plugins of the same name twice and stop at their parameters."""
    for installed in (installed_meshlab() / "plugins" / plugin.name for plugin in plugins):
        if installed.exists():
            owner = (output("dpkg-query", "--search", installed) or "").split(": ")[0]
            raise Failure(f"{installed} is installed for all users and would be loaded twice; to install for you alone, first run: "
                          f"sudo {f'apt remove {owner}' if owner else f'rm {installed}'}")


def install_plugins(plugins):
    """In place of those of other versions."""
    refuse_installed_plugins(plugins)
    folder = extra_plugins_folder()
    folder.mkdir(parents=True, exist_ok=True)
    for plugin in plugins:
        put_file(plugin, folder / plugin.name)
    remove_plugins(but=folder)
    say(f"installed in {folder}; ./run --uninstall removes them")


def uninstall_plugins():
    if not remove_plugins():
        raise Failure(f"./run --install has installed nothing in {all_extra_plugins()}")


def remove_plugins(but=None):
    """With the folders that are empty then, but not the user's .local/share. Returns those that were removed."""
    files = [file for file in all_extra_plugins().glob("*/lib*_laplacian_lines.so") if file.parent != but]
    for file in files:
        file.unlink()
        say(f"removed {file}")
        for folder in list(file.parents)[:4]:
            if not any(folder.iterdir()):
                folder.rmdir()
    return files
