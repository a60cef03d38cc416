# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugins as packages."""

import shutil
import subprocess

from environment.files import put_file, turn
from environment.messages import Failure, quietly, say


KINDS = {"DEB": ["dpkg-deb", "--fsys-tarfile"], "ZIP": ["cmake", "-E", "tar", "tf"]}  # and what reads them


def are_whole(folder, kinds):
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    files = {kind: list(folder.glob(f"*.{kind.lower()}")) for kind in kinds}
    return all(len(some) == 1 and subprocess.run([*KINDS[kind], *some], **quiet).returncode == 0
               for kind, some in files.items())


def packages_in(folder):
    return sorted(file for file in folder.iterdir() if file.suffix in (".deb", ".zip"))


def make_packages(build, folder, kinds=tuple(KINDS)):
    """Of the plugins built there, replacing those in the folder, which stay on failure."""
    scratch, log = build / "packages.new", build / "packages.new.log"
    say("making the packages")
    with turn(build):
        shutil.rmtree(scratch, ignore_errors=True)
        try:
            # CPack would build everything first, but not for generators without a target "preinstall"
            command = ["cpack", "--config", build / "CPackConfig.cmake", "-G", ";".join(kinds), "-D",
                       "CPACK_CMAKE_GENERATOR=Ninja", "-D", f"CPACK_OUTPUT_FILE_PREFIX={scratch}", "-B", scratch]
            if not (quietly(log, command) and are_whole(scratch, kinds)):
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
