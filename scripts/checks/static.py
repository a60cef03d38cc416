# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the text of the code, without a build: cppcheck of modules, names and layout of all C++, shellcheck of all shell
scripts, pyflakes of all Python."""

import re

from checks.names import wrong_names
from environment import packages
from environment.build import CHECKOUT, processors
from environment.files import cache_folder
from environment.messages import Failure, output, run

CPP_FOLDERS = """laplacian_lines mesh_files line_drawing line_renderer filter_laplacian_lines decorate_laplacian_lines
    meshlab_host programs/drawing_program""".split()


def check_statically():
    packages.ensure_packages(*packages.CHECKS)
    files = [CHECKOUT / name for name in output("git", "-c", "safe.directory=*", "-C", CHECKOUT, "ls-files").splitlines()]
    files = [file for file in files if file.is_file()]
    analyse()
    check_layout([file for file in files if file.suffix in (".cpp", ".h")])
    check_shell([file for file in files if re.match(rb"#!.*\b(ba)?sh\b", file.read_bytes())])
    check_python([file for file in files if file.suffix == ".py"])


def analyse():
    kept = cache_folder() / "cppcheck"  # what has not changed is not analysed again
    kept.mkdir(parents=True, exist_ok=True)
    if run(["cppcheck", f"--cppcheck-build-dir={kept}", "--quiet", "--error-exitcode=1", "--std=c++17", "--language=c++",
            "-j", str(processors()), "--enable=warning,performance,portability",
            "--suppressions-list=scripts/checks/cppcheck_suppressions.txt", "-I", "laplacian_lines/include", "-I",
            "laplacian_lines/src", *CPP_FOLDERS], cwd=CHECKOUT, stdout=2) != 0:
        raise Failure("cppcheck found the above: fix it, or say why not in scripts/checks/cppcheck_suppressions.txt")


def check_layout(files):
    if wrong := list(wrong_names(files)):
        raise Failure("names of another convention, see docs/CONTRIBUTING.md:\n" + "\n".join(wrong))
    if run(["clang-format", "--dry-run", "--Werror", *files], stdout=2) != 0:
        raise Failure("clang-format -i lays out the files named above")


def check_shell(files):
    if run(["shellcheck", *files], stdout=2) != 0:
        raise Failure("shellcheck found the above")


def check_python(files):
    said = output("sh", "-c", '"$0" -m pyflakes "$@" 2>&1 || true', "/usr/bin/python3", *files)  # of Debian, as pyflakes is
    # what tests have by "from harness import *" is not known to it
    if found := re.findall(r"^(?!.*(?:import \*|star imports|tests/.* unused)).+$", said, re.M):
        raise Failure("pyflakes found\n" + "\n".join(found))
