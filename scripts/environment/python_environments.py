# SPDX-License-Identifier: GPL-3.0-or-later
"""Python environments in the cache folder."""

import shutil
import subprocess

from environment.files import cache_folder, publish_into
from environment.messages import Failure, Obstacle, output, quietly, say
from environment.packages import ensure_packages


def ensure_python(name, version, size, *packages):
    """The Python of this environment, of about that size, made with the user's Python. Other packages need another
    version. Raises Obstacle."""
    users = shutil.which("python3")
    if output(users, "-c", "import ensurepip, venv") is None:
        try:
            ensure_packages("python3", "python3-venv")
        except Failure as reason:
            say(reason)
            raise Obstacle("python3-venv could not be installed") from None
    users_version = output(users, "-c", "import platform; print(platform.python_version())")
    folder = cache_folder() / name / f"{version}-python{users_version}"
    python, log = folder / "bin/python", folder.with_name(folder.name + ".log")
    if python.exists():
        return python
    say(f"installing {' '.join(packages)} into {folder} ({size})")

    def install(scratch):
        return (subprocess.run([users, "-m", "venv", scratch]).returncode == 0 and
                quietly(log, [scratch / "bin/python", "-m", "pip", "--disable-pip-version-check", "--no-input",
                              "install", *packages]))

    if not publish_into(folder, install):
        raise Obstacle(f"{' '.join(packages)} could not be installed for Python {users_version}; the log is {log}")
    return python
