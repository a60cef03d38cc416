# SPDX-License-Identifier: GPL-3.0-or-later
"""What plugins need of the system that loads them, and what they show to it."""

import re
import sys

from environment.messages import output

LIBRARIES = {f"libQt5{name}.so.5" for name in ("Core", "Gui", "Widgets", "OpenGL", "Xml")} | {
    "libmeshlab-common.so", "libGL.so.1", "libstdc++.so.6", "libgcc_s.so.1", "libm.so.6", "libc.so.6", "ld-linux-x86-64.so.2"}
# of glibc and Qt as docs/install.md has them; of libstdc++ those of GCC 11; of libgcc what plugins use
VERSIONS = {"GLIBC": (2, 34), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "Qt": (5, 15), "GCC": (4, 0, 0)}
EXPORTS = {"qt_plugin_query_metadata", "qt_plugin_instance"}


def needed_versions(plugin):
    """Family and number, those without a number as the greatest."""
    return {(family, tuple(map(int, digits.split("."))) if digits[0].isdigit() else (sys.maxsize,))
            for family, digits in re.findall(r"\(([A-Za-z_0-9]*?)_(\d[\d.]*|PRIVATE\w*)\)", output("objdump", "-T", plugin))}


def excess(plugins, any_version=False):
    """What they need, or show, too much or too little for upstream's MeshLab 2025.07 and the systems that it runs on, a
    sentence each. With any_version, symbols may be as new as they are on this system."""
    found = []
    for plugin in plugins:
        libraries = set(re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-dW", plugin)))
        names = {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--defined-only", plugin).splitlines()}
        versions = {f"{family}_{'.'.join(map(str, number))}" for family, number in needed_versions(plugin)
                    if not any_version and number > VERSIONS.get(family, ())}
        found += [f"{plugin} {verb} {what}" for verb, all_of in (
            ("needs", libraries - LIBRARIES | versions), ("exports", names - EXPORTS), ("does not export", EXPORTS - names))
            for what in sorted(all_of)[:5]]
    return found
