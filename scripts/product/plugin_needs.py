#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plugin_needs.py [--here] PLUGIN...: what plugins need of the system that loads them, and what they show to it; fails
where that is more than upstream's MeshLab 2025.07 and the systems that it runs on have. With --here, versions of
symbols may be as new as they are on this system."""
import re
import subprocess
import sys

LIBRARIES = {f"libQt5{name}.so.5" for name in ("Core", "Gui", "Widgets", "OpenGL", "Xml")} | {
    "libmeshlab-common.so", "libGL.so.1", "libstdc++.so.6", "libgcc_s.so.1", "libm.so.6", "libc.so.6", "ld-linux-x86-64.so.2"}
VERSIONS = {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "Qt": (5, 15), "GCC": (4, 0, 0)}
EXPORTS = {"qt_plugin_query_metadata", "qt_plugin_instance"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed_versions(plugin):
    """Family and number, those without a number as the greatest."""
    return {(family, tuple(map(int, digits.split("."))) if digits[0].isdigit() else (sys.maxsize,))
            for family, digits in re.findall(r"\(([A-Za-z_0-9]*?)_(\d[\d.]*|PRIVATE\w*)\)", output("objdump", "-T", plugin))}


def excess(plugin, any_version):
    """What the plugin needs, or shows, too much or too little, a sentence each."""
    libraries = set(re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-dW", plugin)))
    names = {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--defined-only", plugin).splitlines()}
    versions = [] if any_version else [f"{family}_{'.'.join(map(str, number))}" for family, number in needed_versions(plugin)
                                       if number > VERSIONS.get(family, ())]
    found = [f"needs {what}" for what in sorted(libraries - LIBRARIES) + sorted(versions)]
    found += [f"exports {name}" for name in sorted(names - EXPORTS)[:5]]
    found += [f"does not export {name}" for name in sorted(EXPORTS - names)]
    print(f"{plugin.split('/')[-1]} needs {' '.join(sorted(libraries))}")
    return [f"{plugin} {what}" for what in found]


def main(arguments):
    any_version = arguments[:1] == ["--here"]
    plugins = arguments[1 if any_version else 0:]
    if not plugins:
        sys.exit(__doc__)
    sys.exit("\n".join(what for plugin in plugins for what in excess(plugin, any_version)) or 0)


main(sys.argv[1:])
