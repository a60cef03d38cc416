# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --windows: the command laplacian-lines for Windows, compiled by Debian's MinGW-w64. Run by Wine, its drawings have
to be those of this system, byte by byte: the golden ones, and some of what systems do differently."""

import filecmp
import os
import platform
import shutil

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import Failure, Unavailable, quietly, run

BUILD = CHECKOUT / "build/windows"
PACKAGES = "g++-mingw-w64-x86-64-posix libz-mingw-w64-dev wine64".split()
WINE = "/usr/lib/wine/wine64"
TARGET = "laplacian_lines_drawing"
# In a folder of golden meshes: names in other letters, replaced files, folders, and the mistakes that end with code 1.
DRAWINGS = ((0, "Größe 日本.svg", "--views", "six", "--section", "y=0.5", "--kinds", "all_kinds", "Größe 日本.ply"),
            (0, "again.dxf", "--like", "Größe 日本.svg", "Größe 日本.ply"), (0, "again.dxf", "--hidden", "dashed", "scan.ply"),
            (0, "Zeichnungen ü/", "--format", "pdf", "--views", "30,15", "cup.off", "scan.ply"),
            (1, "missing/plate.svg", "scan.ply"), (1, "scan.ply/plate.svg", "scan.ply"), (1, "plate.svg", "missing.ply"))


def draw(folder, *program):
    """Has the program, of one or more words, fill the folder."""
    log, work = folder.with_suffix(".log"), folder / "golden"
    environment = {**os.environ, "LAPLACIAN_LINES_BUILD": str(folder), "WINEPREFIX": str(BUILD / "wine"), "WINEDEBUG": "-all",
                   "WINEDLLOVERRIDES": "mscoree,mshtml=", "LC_ALL": "C.UTF-8"}
    shutil.rmtree(folder, ignore_errors=True)
    if not quietly(log, ["python3", "-B", CHECKOUT / "tests/golden/golden.py", *program], env=environment):
        raise Failure("drawings are not as they are kept")
    shutil.copy(work / "torus.ply", work / "Größe 日本.ply")
    with log.open("ab") as said:
        for code, *words in DRAWINGS:
            if run([*program, *words], cwd=work, env=environment, stdout=said, stderr=said) != code:
                raise Failure(f"{' '.join(words)} does not end with {code}, see {log}")


def differing(one, other):
    """How many files two folders have, and which are not the same in both."""
    names = sorted({str(file.relative_to(folder)) for folder in (one, other) for file in folder.rglob("*") if file.is_file()})
    _, different, missing = filecmp.cmpfiles(one, other, names, shallow=False)
    return len(names), different + missing


def test():
    if platform.machine() != "x86_64":
        raise Unavailable("the command for Windows is for x86-64")
    packages.ensure_packages(*packages.CORE, *PACKAGES)
    build_targets(TARGET, preset="windows", build=BUILD)
    build_targets(TARGET, preset="tests", extra_packages=[*packages.DISPLAY, *packages.TEST])
    draw(BUILD / "here", build_folder() / "bin/laplacian-lines")
    draw(BUILD / "there", WINE, BUILD / "bin/laplacian-lines.exe")
    count, others = differing(BUILD / "here", BUILD / "there")
    if others:
        raise Failure(f"{', '.join(others)} in {BUILD}/here and there differ")
    return f"{count} files have the same bytes"
