# SPDX-License-Identifier: GPL-3.0-or-later
"""./test --aarch64: the core, the command laplacian-lines and the plugins for another processor, compiled by Debian's cross
compiler in a root of its own. Run by qemu, fields, lines and drawings of the core and the command have to be those of this
processor, bit by bit; the plugins are built alone."""

import filecmp
import platform
import shlex
import shutil

from environment import packages
from environment.build import CHECKOUT, build_folder, build_targets
from environment.messages import Failure, Unavailable, run
from hosts.roots import SUITES, run_in_root, run_with_network

BUILD = CHECKOUT / "build/aarch64"
TARGETS = "print_bits write_reference laplacian_lines_drawing".split()
PLUGINS = "filter_laplacian_lines decorate_laplacian_lines".split()
MESHES = "torus bumpy_sphere cube moebius_strip three_sheets rounded_cube triangle_soup doubled_triangles".split()
DRAWINGS = {"usual.svg": [], "all.svg": ["--kinds", "all_kinds", "--scale", "10:1"],
            "six.pdf": ["--views", "six", "--section", "y=0.5"], "six.dxf": ["--views", "six", "--hidden", "dashed"]}


def install(root, kept, log):
    native = "g++-aarch64-linux-gnu qemu-user make cmake ccache xz-utils libeigen3-dev"
    foreign = """libgtest-dev qtbase5-dev libqt5opengl5-dev libglew-dev zlib1g-dev libstb-dev libgl-dev libglu1-mesa-dev
        meshlab""".split()
    return run_with_network(root, kept, ["sh", "-exc", f"""dpkg --add-architecture arm64
apt-get -qq update
DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install {native} {' '.join(f'{n}:arm64' for n in foreign)}
python3 -B -c 'from environment.headers import ensure_headers as e; e()'"""], log)


def run_there(*command):
    run_in_root(SUITES["2020"], BUILD, command, "-arm64", install)


def bits_command(build, folder, *emulator):
    """Writes hashes and drawings into the folder, by the programs of a build."""
    programs = [f"{shlex.join([*emulator, f'{build}/tests/core/print_bits', *MESHES])} >bits.txt"]
    programs += [shlex.join([*emulator, f"{build}/bin/laplacian-lines", name, *options, "../torus.ply"])
                 for name, options in DRAWINGS.items()]
    return "sh", "-ec", "; ".join([f"cd {shlex.quote(str(folder))}", *programs])


def test():
    if platform.machine() == "aarch64":
        raise Unavailable("this is that processor; the core's tests run here")
    program = f"from environment.build import build_targets as b; b(*{TARGETS + PLUGINS}, preset='aarch64')"
    run_there("python3", "-B", "-c", program)
    build_targets(*TARGETS, preset="tests", extra_packages=[*packages.DISPLAY, *packages.TEST])
    work, names = BUILD / "bits", ["bits.txt", *DRAWINGS]
    shutil.rmtree(work, ignore_errors=True)
    for place in ("here", "there"):
        (work / place).mkdir(parents=True)
    here = bits_command(build_folder(), work / "here")
    if run([build_folder() / "tests/meshes/write_reference", "torus", work]) != 0 or run(here) != 0:
        raise Failure("here, there are no bits")
    run_there(*bits_command(BUILD, work / "there", "qemu-aarch64"))
    _, different, missing = filecmp.cmpfiles(work / "here", work / "there", names, shallow=False)
    if different or missing:
        raise Failure(f"{', '.join(different + missing)} in {work}/here and there differ")
    return f"{len(MESHES)} meshes and {len(DRAWINGS)} drawings have the same bits"
