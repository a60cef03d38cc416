# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be used raises an exception that says what can."""

import importlib.metadata
import os
import pathlib
import pydoc
import signal
import tempfile
import threading
import time
import unittest

import laplacian_lines as ll
import numpy
from shapes import sphere, torus

FRONT = dict(direction=(0, 0, 1))


class Refusals(unittest.TestCase):
    def expect(self, error, words, function, *arguments, **keywords):
        with self.assertRaisesRegex(error, words):
            function(*arguments, **keywords)

    def test_options(self):
        mesh = sphere(steps=2)
        self.assertTrue(issubclass(ll.Error, ValueError))
        self.expect(TypeError, "'kernelsize'. Did you mean kernel_size", ll.field, mesh, kernelsize=1)
        self.expect(TypeError, "no option 'detail'", ll.field, mesh, detail=1)
        self.expect(ll.Error, "\"Kernel Size\" is -1. It has to be at least 0", ll.field, mesh, kernel_size=-1)
        self.expect(ll.Error, "\"Detail\" is nan. It has to be between 0 and 100", ll.lines, mesh, detail=float("nan"), **FRONT)
        for given, words in (({"normal_smoothing": "round"}, "'None', 'Gaussian'"), ({"normal_smoothing": 2}, "'None', 'Gaussian'"),
                             ({"weld_duplicates": 0.5}, "of type bool"), ({"kernel_size": "1 mm"}, "of type float")):
            self.expect(TypeError, words, ll.field, mesh, **given)
        self.expect(ll.Error, '"rigdes" are not kinds of lines.*ridges', ll.lines, mesh, kinds="rigdes", **FRONT)
        self.expect(TypeError, r"give kernel_size to Surface", ll.lines, ll.Surface(mesh), kernel_size=1, **FRONT)

    def test_views(self):
        mesh = sphere(steps=2)
        self.expect(TypeError, "Say from where: direction", ll.lines, mesh)
        self.expect(ValueError, "three finite numbers", ll.lines, mesh, direction=(0, 1))
        self.expect(ValueError, "three finite numbers", ll.visible_lines, mesh, eye=(0, numpy.nan, 1))
        self.expect(ValueError, "^direction has no length", ll.lines, mesh, direction=(0, 0, 0))
        self.expect(ValueError, "to the eye has no length: give a direction", ll.lines, mesh, eye=(0, 0, 0))

    def test_meshes(self):
        vertices, faces = sphere(steps=2)
        self.expect(TypeError, "A int is no mesh", ll.field, 3)
        for words, mesh in ((r"shape \(66, 2\)", (vertices[:, :2], faces)),
                            ("split into triangles", (vertices, numpy.zeros((2, 4), int))),
                            ("whole", (vertices, faces.astype(float))), ("vertex -1", (vertices, faces - 1)),
                            ("vertex", (vertices, faces + 1)), ("triangle", (vertices, faces[:0]))):
            self.expect(ll.Error, words, ll.field, mesh)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            self.expect(FileNotFoundError, "none.ply", ll.field, place / "none.ply")
            (place / "mesh.txt").write_text("ply")
            self.expect(ll.Error, "Save it as .ply", ll.read_mesh, place / "mesh.txt")
            (place / "mesh.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
            self.expect(ll.Error, "is incomplete: ", ll.read_mesh, place / "mesh.off")
            self.expect(OSError, "", ll.write_drawing, place / "none" / "a.svg", (sphere(steps=2)))

    def test_without_the_plugin(self):
        try:
            import pymeshlab  # noqa: F401
        except ImportError:
            self.expect(ImportError, "pymeshlab", ll.load)
        else:
            self.expect(ImportError, "./run --python builds it", ll.load)

    def test_interrupts(self):
        mesh = torus(2000, 1000)
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                ll.field(mesh)
        self.assertLess(time.monotonic() - began, 60)


class Help(unittest.TestCase):
    def test_tells_options_with_limits(self):
        text = pydoc.render_doc(ll, renderer=pydoc.plaintext)
        for words in ("visible_lines(", "write_drawing(", "trimesh", "(n, 3)", "kernel_size: float = 0.0", "0 or more", "√h"):
            self.assertIn(words, text)
        self.assertNotIn("&radic;", text)
        text = " ".join(pydoc.render_doc(ll.lines, renderer=pydoc.plaintext).split())
        self.assertIn("detail: float = 50.0, contours: bool = True", text)

    def test_version(self):
        self.assertEqual(ll.__version__, importlib.metadata.version("laplacian_lines"))


class Types(unittest.TestCase):
    def test_checkers_know_options(self):
        try:
            import mypy.api
        except ImportError:
            self.skipTest("mypy is not here")
        good = "import laplacian_lines as ll\nlines: ll.Polylines = ll.visible_lines('a.ply', eye=(0, 0, 1), detail=40)\n"
        bad = "ll.field('a.ply', kernelsize=1)\nll.Surface('a.ply').lines(direction=(0, 0, 1), detail='much')\n"
        said, errors, code = mypy.api.run(["--strict", "-c", good])
        self.assertEqual(code, 0, said + errors)
        said, errors, _ = mypy.api.run(["--strict", "-c", good + bad])
        self.assertIn("kernelsize", said)
        self.assertIn("Found 2 errors", said)
