# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugins as packages."""

import shutil
import subprocess

from environment.files import put_file, turn
from environment.messages import Failure, quietly, say


def are_whole(folder):
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    files = list(folder.glob("*.deb")), list(folder.glob("*.zip"))
    return all(len(some) == 1 for some in files) and all(subprocess.run(command, **quiet).returncode == 0
                                                         for command in (
        ["dpkg-deb", "--fsys-tarfile", *files[0]], ["cmake", "-E", "tar", "tf", *files[1]]))


def packages_in(folder):
    return sorted(file for file in folder.iterdir() if file.suffix in (".deb", ".zip"))


def make_packages(build, folder):
    """Of the plugins that are built there, in place of those in the folder, which stay if they cannot be made."""
    scratch, log = build / "packages.new", build / "packages.new.log"
    say("making the packages")
    with turn(build):
        shutil.rmtree(scratch, ignore_errors=True)
        try:
            # CPack would first build all that can be built; it does not for generators without a target "preinstall"
            command = ["cpack", "--config", build / "CPackConfig.cmake", "-D", "CPACK_CMAKE_GENERATOR=Ninja", "-D",
                       f"CPACK_OUTPUT_FILE_PREFIX={scratch}", "-B", scratch]
            if not (quietly(log, command) and are_whole(scratch)):
                raise Failure(f"the packages could not be made; the whole output is in {log}")
            folder.mkdir(parents=True, exist_ok=True)
            for package in packages_in(scratch):
                put_file(package, folder / package.name)
                say(folder / package.name)
            for package in packages_in(folder):
                if not (scratch / package.name).exists():  # of another version
                    package.unlink()
        finally:
            shutil.rmtree(scratch, ignore_errors=True)
