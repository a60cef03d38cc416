# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds by clang, with warnings as errors and with sanitizers, for other checks to run."""

import contextlib
import os

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets, ensure_toolchain
from environment.messages import say

PACKAGES = "clang libclang-rt-dev llvm cppcheck shellcheck".split()


def checks_folder():
    return build_folder() / "checks"


@contextlib.contextmanager
def environment(**values):
    """Sets variables for the block."""
    before = dict(os.environ)
    os.environ.update(values)
    try:
        yield
    finally:
        os.environ.clear()
        os.environ.update(before)


def build_with_clang(folder, preset, *targets):
    """All targets if none is named. Warnings are errors."""
    # for ccache, which would otherwise hash this file's name instead of its contents
    ignored = CHECKOUT / "scripts/cmake/sanitizer_ignorelist.txt"
    with environment(LAPLACIAN_LINES_BUILD=str(folder), CCACHE_IGNOREOPTIONS="-fsanitize-ignorelist=*",
                     CCACHE_EXTRAFILES=str(ignored)):
        ensure_toolchain(*packages.TEST, *PACKAGES)
        say(f"building {' '.join(targets) or 'all'} with clang: {preset}")
        build_targets(*targets, preset=preset)


def build_checks(*targets):
    build_with_clang(checks_folder(), "sanitizers", *targets)
