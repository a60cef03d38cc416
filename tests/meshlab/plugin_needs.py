#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plugin_needs.py LIBRARY PLUGIN...: the plugins that are built here need and show no more than any MeshLab's system has;
of MeshLab's own library it is said what is too much."""
import pathlib
import subprocess
import sys

CHECK = pathlib.Path(__file__).resolve().parents[2] / "scripts/product/plugin_needs.py"
library, plugins = sys.argv[1], sys.argv[2:]


def check(*files):
    result = subprocess.run([sys.executable, CHECK, "--here", *files], capture_output=True, text=True)
    print(result.stdout, result.stderr, sep="", end="")
    return result


assert plugins and check(*plugins).returncode == 0
refused = check(library)
assert refused.returncode == 1
for sentence in "needs libGLEW", "exports _Z", "does not export qt_plugin_instance":
    assert f"{library} {sentence}" in refused.stderr, sentence
