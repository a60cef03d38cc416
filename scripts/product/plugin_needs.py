#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plugin_needs.py [--here] PLUGIN...: what plugins need of the system that loads them, and what they show to it; fails
where that is more than upstream's MeshLab 2025.07 and the systems that it runs on have. With --here, versions of
symbols may be as new as they are on this system."""
import re
import subprocess
import sys

QT = {f"libQt5{name}.so.5" for name in ("Core", "Gui", "Widgets", "OpenGL", "Xml")}
SYSTEM = {"libGL.so.1", "libstdc++.so.6", "libgcc_s.so.1", "libm.so.6", "libc.so.6", "ld-linux-x86-64.so.2"}
LIBRARIES = QT | SYSTEM | {"libmeshlab-common.so"}
VERSIONS = {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "Qt": (5, 15), "GCC": (4, 0, 0)}
EXPORTS = {"qt_plugin_query_metadata", "qt_plugin_instance", "laplacian_lines_tables"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed_libraries(plugin):
    return set(re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-dW", plugin)))


def needed_versions(plugin):
    """The highest of each family, such as GLIBC; those without a number as they are."""
    highest = {}
    for family, digits in re.findall(r"\(([A-Za-z_0-9]*?)_(\d[\d.]*|PRIVATE\w*)\)", output("objdump", "-T", plugin)):
        number = tuple(map(int, digits.split("."))) if digits[0].isdigit() else (sys.maxsize,)
        highest[family] = max(highest.get(family, ()), number)
    return highest


def exports(plugin):
    return {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--defined-only", plugin).splitlines()}


def excess(plugin, any_version):
    """Prints what the plugin needs and exports; returns what is too much, a sentence each."""
    libraries, versions, names = needed_libraries(plugin), needed_versions(plugin), exports(plugin)
    numbers = {family: ".".join(map(str, number)) for family, number in versions.items()}
    print(f"{plugin.split('/')[-1]}\n  needs {' '.join(sorted(libraries))}"
          f"\n  at least {' '.join(f'{family}_{number}' for family, number in sorted(numbers.items()))}"
          f"\n  exports {' '.join(sorted(names)) if len(names) < 9 else f'{len(names)} symbols'}")
    found = [f"needs {library}" for library in sorted(libraries - LIBRARIES)]
    if not any_version:
        found += [f"needs {family}_{numbers[family]}" for family in sorted(versions)
                  if versions[family] > VERSIONS.get(family, ())]
    found += [f"exports {name}" for name in sorted(names - EXPORTS)[:5]]
    found += [f"does not export {name}" for name in ("qt_plugin_query_metadata", "qt_plugin_instance") if name not in names]
    return [f"{plugin} {what}" for what in found]


def main(arguments):
    any_version = arguments[:1] == ["--here"]
    plugins = arguments[1 if any_version else 0:]
    if not plugins:
        sys.exit(__doc__)
    found = [what for plugin in plugins for what in excess(plugin, any_version)]
    sys.exit("\n".join(found) or 0)


main(sys.argv[1:])
