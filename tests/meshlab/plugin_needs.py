# SPDX-License-Identifier: GPL-3.0-or-later
"""plugin_needs.py LIBRARY PLUGIN...: the plugins that are built here need and show no more than any MeshLab's system has;
of MeshLab's own library it is said what is too much."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from product.plugin_needs import excess

library, *plugins = sys.argv[1:]
assert plugins and not excess(plugins, any_version=True), excess(plugins, any_version=True)
found = "\n".join(excess([library], any_version=True))
for sentence in "needs libGLEW", "exports _Z", "does not export qt_plugin_instance":
    assert f"{library} {sentence}" in found, found
