# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured drawings: the command's, and what keyword arguments make of its options."""

import json
import pathlib
import re
import tempfile
import unittest
import xml.etree.ElementTree

import laplacian_lines as ll
from shapes import REFERENCE, sphere, torus


class Drawings(unittest.TestCase):
    def test_are_the_commands_byte_for_byte(self):
        """Those that bare_environments.py had it write, with these options."""
        mesh = REFERENCE / "torus.ply"
        for name, given in json.loads((REFERENCE / "drawings.json").read_text()).items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / name
                drawing = ll.write_drawing(file, mesh, **given)
                self.assertEqual(file.read_bytes(), (REFERENCE / name).read_bytes())
                self.assertEqual(drawing.content, file.read_bytes())
                self.assertEqual(drawing.format, file.suffix[1:])

    def test_are_at_true_scale(self):
        drawing = ll.make_drawing(sphere(radius=2, steps=5), unit="cm", scale="1:2", paper="fit", annotations=False,
                                  strokes="plain")
        self.assertEqual(drawing.scale, 0.5)  # 4 cm, half as large
        self.assertEqual(drawing.paper, (20 + 2 * 10, 20 + 2 * 10 + 16))  # with margins, and room for a note
        root = xml.etree.ElementTree.fromstring(drawing.content)
        self.assertEqual([root.get(side) for side in ("width", "height")], ["40mm", "56mm"])
        [data] = re.findall(r'id="front-outline".*? d="M([-\d.]+)[ -]', drawing._repr_svg_(), re.S)
        self.assertTrue(10 - 0.1 < float(data) < 30 + 0.1, data)

    def test_of_several_meshes_hide_each_other(self):
        vertices, faces = sphere(steps=4)
        behind = (vertices / 2 - (0, 0, 3), faces)
        alone = ll.make_drawing((vertices, faces), annotations=False, scale="10:1").content
        both = ll.make_drawing((vertices, faces), behind, annotations=False, scale="10:1", kinds="contours").content
        self.assertEqual(re.findall(rb' d="[^"]*"', both), re.findall(rb' d="[^"]*"', alone))

    def test_take_options_as_python_has_them(self):
        plain = ll.make_drawing(torus(), views=["front", "30,15"], annotations=False, wall=1)
        written = ll.make_drawing(torus(), views="front,30,15", annotations=0, wall="Filled")
        self.assertEqual(plain, written)
        self.assertEqual(ll.make_drawing(torus(), format="SVG"), ll.make_drawing(torus()))
        self.assertIn('"--annotations","none"', plain.content.decode())

    def test_say_what_can_be_used(self):
        for given, error, words in (
                ({"paper": "a9"}, TypeError, "must be 'a5', 'a4'"), ({"views": "inside"}, ll.Error, "is not a view"),
                ({"view": "six"}, TypeError, "Did you mean views"), ({"views": [3]}, TypeError, "a text or several"),
                ({"annotations": "none"}, TypeError, "of type bool"), ({"scale": "9:1", "unit": "m"}, ll.Error, "paper"),
                ({"format": "png", "dpi": 5}, ll.Error, "between 20 and 2400"), ({"dpi": "x"}, TypeError, "of type float"),
                ({"format": "png", "title": "日"}, ll.Error, "SVG or DXF"), ({"format": "doc"}, ll.Error, r"\.svg")):
            with self.subTest(given):
                self.assertRaisesRegex(error, words, ll.make_drawing, torus(), **given)
        self.assertRaisesRegex(ll.Error, "object", ll.make_drawing)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "old.svg"
            file.write_text("old")
            self.assertRaises(ll.Error, ll.write_drawing, file, torus(), scale="1:0")
            self.assertEqual(file.read_text(), "old")
