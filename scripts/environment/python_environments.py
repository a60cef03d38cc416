# SPDX-License-Identifier: GPL-3.0-or-later
"""Python environments in the cache folder."""

import shutil
import subprocess

from environment.files import cache_folder
from environment.messages import Failure, Unavailable, output, quietly, say
from environment.packages import ensure_packages


def ensure_python(name, version, size, *packages):
    """The Python of this environment, of about that size, made with the user's Python. Other packages need another
    version. Raises Unavailable."""
    users = shutil.which("python3")
    try:
        if output(users, "-c", "import ensurepip, venv") is None:
            ensure_packages("python3-venv")
    except Failure as reason:
        raise Unavailable(reason) from None
    users_version = output(users, "-c", "import platform; print(platform.python_version())")
    folder = cache_folder() / name / f"{version}-python{users_version}"
    python, done = folder / "bin/python", folder / "done"
    if not done.exists():
        say(f"installing {' '.join(packages)} into {folder} ({size})")
        if (subprocess.run([users, "-m", "venv", "--clear", folder]).returncode != 0 or
                not quietly(folder / "log", [python, "-m", "pip", "--disable-pip-version-check", "--no-input", "install",
                                             *packages])):
            raise Unavailable(f"{' '.join(packages)} could not be installed for Python {users_version}; the log is {folder}/log")
        done.touch()
    return python
