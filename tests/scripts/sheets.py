# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of many pictures are no wider than a screen and no higher than ImageMagick allows, and what belongs together
stands in rows of its own."""
from harness import *

from product.sheet import lay_out, make_sheet, sheet_rows


class Sheets(ScriptTest):
    def test_layout(self):
        for columns, cell, size, count, together in (
                (3, (1200, 900), (1200, 900), 18, 18),  # all kinds of lines of a mesh
                (3, (1200, 900), (1200, 900), 36, 18),  # of two
                (2, (1200, 900), (1200, 900), 8, 4),  # rows of four would be too wide, rows of three and one uneven
                (2, (1200, 900), (1200, 900), 2, 2), (3, (500, 400), (500, 400), 7, 7),
                (6, (300, 200), (300, 200), 12, 6),
                (1, (5000, 400), (5000, 400), 3, 3),
                (6, (614, 460), (1200, 900), 100, 1)):  # a hundred meshes
            self.assertEqual(lay_out(size, count, together), (columns, cell))

    def test_largest(self):
        for size in ((1200, 900), (300, 4000), (9000, 100)):
            for count in (1, 7, 40, 400):
                for together in (1, 3, 18):
                    columns, (width, height) = lay_out(size, count, together)
                    self.assertTrue(columns * (width + 16) <= 3840 or columns == 1)
                    self.assertTrue(sheet_rows(columns, count, together) * (height + 76) <= 16000 or width <= 100)

    def test_rows(self):
        """Five pictures and five others, in rows of three: the sixth cell is empty."""
        for color in ("black", "red"):
            subprocess.run(["convert", "-size", "1000x50", f"xc:{color}", f"{color}.png"], check=True)
        make_sheet("sheet.png", (1000, 50), 5,
                   [(str(number), f"{color}.png") for color in ("black", "red") for number in range(5)])
        width, height = map(int, subprocess.check_output(["identify", "-format", "%w %h", "sheet.png"]).split())
        self.assertEqual((width, height % 4), (3048, 0))
        colors = [subprocess.check_output(["convert", "sheet.png", "-format",
                                           f"%[hex:u.p{{{1016 * x + 500},{height // 4 * y + 20}}}]", "info:"],
                                          text=True) for x, y in ((0, 0), (1, 1), (2, 1), (0, 2), (1, 3), (2, 3))]
        self.assertEqual(colors, ["000000", "000000", "FFFFFF", "FF0000", "FF0000", "FFFFFF"])


unittest.main()
