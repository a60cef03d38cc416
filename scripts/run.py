# SPDX-License-Identifier: GPL-3.0-or-later
"""./run: product/command.py. Drawing a small part takes less time than importing what it does not need."""

import os
import pathlib
import sys
import tempfile

from environment.messages import run_main


def main():
    words = sys.argv[1:]
    with tempfile.TemporaryDirectory() as work:
        if not os.environ.get("XDG_RUNTIME_DIR"):  # Qt would make one that stays
            os.mkdir(f"{work}/runtime", 0o700)
            os.environ["XDG_RUNTIME_DIR"] = f"{work}/runtime"
        if words[:1] == ["--drawing"]:
            from product.drawing import run_drawing
            return run_drawing(words[1:], pathlib.Path(work))
        from product.command import run_command
        return run_command(words, pathlib.Path(work))


run_main(main)
