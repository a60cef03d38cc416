# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugins as packages."""

import shutil

from environment.files import put_file, locked
from environment.messages import Failure, quietly, say


def packages_in(folder):
    return sorted(file for file in folder.iterdir() if file.suffix in (".deb", ".zip"))


def make_packages(build, folder, kinds=("DEB", "ZIP")):
    """Of the plugins built there, replacing those in the folder, which stay on failure."""
    scratch, log = build / "packages.new", build / "packages.new.log"
    say("making the packages")
    with locked(build):
        shutil.rmtree(scratch, ignore_errors=True)
        # CPack would build everything first, but not for generators without a target "preinstall"
        made = quietly(log, ["cpack", "--config", build / "CPackConfig.cmake", "-G", ";".join(kinds), "-D",
                             "CPACK_CMAKE_GENERATOR=Ninja", "-D", f"CPACK_OUTPUT_FILE_PREFIX={scratch}", "-B", scratch])
        if not made or len(packages_in(scratch)) != len(kinds):
            raise Failure(f"the packages could not be made; the whole output is in {log}")
        folder.mkdir(parents=True, exist_ok=True)
        for package in packages_in(folder):
            if not (scratch / package.name).exists():  # of another version
                package.unlink()
        for package in packages_in(scratch):
            put_file(package, folder / package.name)
            say(folder / package.name)
        shutil.rmtree(scratch)
