# SPDX-License-Identifier: GPL-3.0-or-later
import concurrent.futures
import threading
import unittest

import laplacian_lines as ll
import numpy
from shapes import bumpy, torus


def same(a, b):
    return all(numpy.array_equal(getattr(a, name), getattr(b, name)) for name in ("points", "offsets", "kinds", "weights"))


class Lines(unittest.TestCase):
    def test_outlines_of_a_torus_are_its_circles(self):
        lines = ll.visible_lines(torus(), direction=(0, 0, 1), kinds=["contours"])
        self.assertEqual(set(lines.by_kind()), {"contours"})
        radii = sorted(numpy.hypot(*line.page.T).mean() for line in lines)
        numpy.testing.assert_allclose(radii, [0.6, 1.4], atol=0.01)
        self.assertTrue(lines.closed.all())
        for line in lines:
            numpy.testing.assert_array_equal(line.points[0], line.points[-1])

    def test_shapes(self):
        lines = ll.lines(bumpy(), eye=(3, 2, 4))
        points = len(lines.points)
        self.assertEqual((lines.points.shape, lines.page.shape, lines.weights.shape), ((points, 3), (points, 2), (points,)))
        self.assertEqual(sum(len(line.points) for line in lines), points)
        self.assertTrue(((lines.weights >= 0) & (lines.weights <= 1)).all())
        self.assertFalse((lines.hidden | lines.outline).any())

    def test_the_page(self):
        lines = ll.lines(torus(), direction=(0, -1, 0), up=(0, 0, 1))
        numpy.testing.assert_allclose(lines.page, lines.points[:, [0, 2]], atol=1e-12)
        seen = ll.visible_lines(torus(), eye=(0, 0, 10), kinds="contours")
        numpy.testing.assert_allclose(seen.page, seen.points[:, :2] / (10 - seen.points[:, 2:]), atol=1e-12)
        for direction, up, upwards in (((0, 1, 0), (0, 1, 0), (0, 0, -1)), ((0, -1, 0), (0, 1, 0), (0, 0, 1)),
                                       ((0, 0, 1), (0, 0, 1), (0, 1, 0)), ((1, 1, 1), (1, 1, 1), (-1, 2, -1))):
            page = ll.lines(torus(), direction=direction, up=up).plane  # from above and below, as drawings are
            numpy.testing.assert_allclose(page.up, numpy.array(upwards) / numpy.linalg.norm(upwards), atol=1e-12)
        self.assertNotEqual(lines.plane, seen.plane)
        self.assertTrue(same(ll.lines(torus(), direction=(0, -1e-200, 0), up=(0, 0, 1e200)), lines))

    def test_hidden_parts(self):
        side = dict(direction=(0, 1, 0.2), kinds="contours")
        seen, all_lines = (ll.visible_lines(torus(), hidden=hidden, **side) for hidden in (False, True))
        joined = ll.visible_lines(torus(), joined_in_picture=True, **side)
        self.assertTrue(joined.closed[joined.outline].all())
        self.assertFalse(seen.hidden.any())
        self.assertTrue(all_lines.hidden.any())
        self.assertEqual((~all_lines.hidden).sum(), len(seen))

    def test_strokes_are_those_of_a_drawing(self):
        surface = ll.Surface(bumpy())
        side = dict(direction=(0.3, 1, 0.6))
        strokes, parts = surface.strokes(**side), surface.visible_lines(**side)
        self.assertLess(len(strokes), len(parts) / 2)
        self.assertTrue(strokes.outline.any())
        u = numpy.arctan2(strokes.points[:, 1], strokes.points[:, 0])
        tube = numpy.hypot(numpy.hypot(strokes.points[:, 0], strokes.points[:, 1]) - 1, strokes.points[:, 2])
        self.assertTrue(((tube > 0.3) & (tube < 0.5)).all(), "a stroke leaves the surface")
        self.assertGreater(numpy.ptp(u), 3)
        self.assertFalse(same(surface.strokes(size=30, **side), strokes), "the size on paper does not count")
        small, large = (len(surface.strokes(detail=d, **side).points) for d in (0, 100))
        self.assertLess(small, large)
        seen = surface.strokes(eye=(0, 0, 10))
        numpy.testing.assert_allclose(seen.page, seen.points[:, :2] / (10 - seen.points[:, 2:]), atol=1e-12)

    def test_options_and_kinds(self):
        mesh = bumpy()
        surface = ll.Surface(mesh)
        few, many = (len(surface.lines(direction=(1, 2, 3), detail=d).points) for d in (10, 90))
        self.assertLess(few, many)
        without = surface.lines(direction=(1, 2, 3), kinds="contours", contours=False)
        self.assertEqual(len(without), 0)
        self.assertEqual(repr(without), "<Polylines: none; 0 points>")
        apparent = surface.lines(direction=(1, 2, 3), kinds="apparent ridges", apparent_curvature=1, apparent_slope=0)
        self.assertIn("apparent_ridges", apparent.by_kind())
        self.assertTrue(same(ll.lines(mesh, direction=(1, 2, 3), kernel_size=0.2),
                             ll.Surface(mesh, kernel_size=0.2).lines(direction=(1, 2, 3))))

    def test_light(self):
        surface = ll.Surface(bumpy())
        here, there = (surface.lines(direction=(1, 2, 3), light=light) for light in (None, (0, 0, 1)))
        self.assertFalse(same(here, there))


class Threads(unittest.TestCase):
    def test_several_share_a_surface(self):
        surface, kinds = ll.Surface(bumpy()), ("usual", "suggestive_contours", "apparent_ridges", "demarcating_curves")
        views = [dict(direction=(1, 2, z), kinds=kinds[z % 4]) for z in range(8)]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            at_once = list(pool.map(lambda view: surface.visible_lines(**view), views))
        alone = ll.Surface(bumpy())
        for found, view in zip(at_once, views):
            self.assertTrue(same(found, alone.visible_lines(**view)))

    def test_others_go_on(self):
        """While the core works, another thread gets Python's lock many times."""
        count, done = 0, threading.Event()

        def work():
            ll.field(torus(600, 300))
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.wait(0.0005):
            count += 1
        thread.join()
        self.assertGreater(count, 20)
