# SPDX-License-Identifier: GPL-3.0-or-later
"""on_display.py COMMAND ARGS...: runs a command on a virtual display with OpenGL in software."""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from environment.messages import run, run_main
from product.display import display


def main():
    with display(640, 480):
        return run(sys.argv[1:], env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"})


run_main(main)
