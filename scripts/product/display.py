# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual X display of our own, and a home folder for one run of MeshLab."""

import contextlib
import os
import subprocess

from environment.messages import Failure, started

# Keeps MeshLab from asking whether it may send statistics.
SETTINGS = "[General]\ninformativeShown=true\n"
QT_LOOKS = """QT_STYLE_OVERRIDE QT_QPA_PLATFORMTHEME QT_SCALE_FACTOR QT_AUTO_SCREEN_SCALE_FACTOR
    QT_SCREEN_SCALE_FACTORS""".split()


@contextlib.contextmanager
def display(width, height):
    """An Xvfb of this size; DISPLAY names it."""
    told, tells = os.pipe()
    # Xvfb picks a free display itself and writes it to the descriptor once it accepts clients.
    with started(["Xvfb", "-displayfd", str(tells), "-screen", "0", f"{width}x{height}x24", "+extension", "GLX", "-nolisten", "tcp",
                  "-noreset"], pass_fds=[tells], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL):
        os.close(tells)
        with open(told, encoding="ascii") as answer:
            number = answer.readline().strip()
        if not number:
            raise Failure("the virtual display Xvfb did not start")
        for name in ("XAUTHORITY", "WAYLAND_DISPLAY"):
            os.environ.pop(name, None)
        os.environ.update(DISPLAY=f":{number}", QT_QPA_PLATFORM="xcb")
        yield


def private_home(home):
    """The environment for a program with this home folder, made here: the user's settings neither matter nor change."""
    (home / ".config/VCG").mkdir(parents=True, exist_ok=True)
    settings = home / ".config/VCG/MeshLab_64bit_fp.conf"
    if not settings.exists():
        settings.write_text(SETTINGS)
    (home / "runtime").mkdir(mode=0o700, exist_ok=True)
    places = {"HOME": home, "XDG_CONFIG_HOME": home / ".config", "XDG_CACHE_HOME": home / ".cache",
              "XDG_DATA_HOME": home / ".local/share", "XDG_RUNTIME_DIR": home / "runtime", "LC_ALL": "C.UTF-8"}
    kept = {name: value for name, value in os.environ.items() if name not in QT_LOOKS}
    return {**kept, **{name: str(place) for name, place in places.items()}}
