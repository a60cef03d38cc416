# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of pictures of one size, each with a label, as wide as a screen shows."""

import subprocess

from environment.messages import Failure

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"  # of the packages of displays
WIDTH, HEIGHT = 3840, 16000  # pixels, at most: the widest usual screen; ImageMagick's limit
GAP, LABEL_HEIGHT = 8, 60  # around a cell; two lines


def escaped_label(text):
    """For ImageMagick, which reads UTF-8 and interprets %, \\ and a first @."""
    text = "".join(character if character.isprintable() else "?" for character in text)
    text = text.replace("\\", "\\\\").replace("%", "%%")
    return f"\\{text}" if text.startswith("@") else text


def whole_share(n, parts):
    """Rounded up."""
    return -(-n // parts)


def lay_out(size, count, together):
    """The columns for `count` cells, of which `together` belong together: in one row if they fit, else in rows of about
    equal length; otherwise as many rows as columns. And the size of cells, smaller than the pictures if the sheet would
    be too high."""
    width, height = size
    most = max(1, WIDTH // (width + 2 * GAP))
    if 1 < together < count:
        columns = whole_share(together, whole_share(together, most))
    else:
        columns = next(c for c in range(1, most + 1) if c * c >= count or c == most)
    rows = whole_share(count, together) * whole_share(together, columns) if together > 1 else whole_share(count, columns)
    if width <= 100 or rows * (height + LABEL_HEIGHT + 2 * GAP) <= HEIGHT:
        return columns, size
    return lay_out((width * 4 // 5, height * 4 // 5), count, together)


def make_sheet(file, size, together, cells):
    """From pairs of label and picture."""
    columns, (width, height) = lay_out(size, len(cells), together)
    words = []
    for number, (label, picture) in enumerate(cells, 1):
        words += ["-label", label, picture]
        if together > 1 and number % together == 0:
            words += ["-label", "", "null:"] * (-together % columns)  # empty cells after those that stand together
    if subprocess.run(["montage", "-font", FONT, "-pointsize", "18", *words, "-tile", f"{columns}x", "-geometry",
                       f"{width}x{height}+{GAP}+{GAP}", file]).returncode != 0:
        raise Failure("ImageMagick's montage could not put the sheet together")
