# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are there whole or not at all."""

import os
import pathlib
import tempfile


def write_whole(name, content):
    """Writes bytes as a file, or as what it links to: what was there stays until all is written, and if it cannot be.

    Devices and pipes are written into. Raises OSError.
    """
    place = pathlib.Path(name).resolve()
    if place.exists() and not place.is_file():
        place.write_bytes(content)  # of a folder, an error that says so
        return
    number, beside = tempfile.mkstemp(dir=place.parent, prefix=".laplacian_lines_")
    try:
        with os.fdopen(number, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(beside, 0o666 & ~mask)
        os.replace(beside, place)
    except BaseException:
        os.unlink(beside)
        raise
