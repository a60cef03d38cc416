# SPDX-License-Identifier: GPL-3.0-or-later
import unittest

import laplacian_lines as ll
import numpy
from shapes import sphere


class Field(unittest.TestCase):
    def test_signs_on_a_sphere(self):
        vertices, faces = sphere(radius=2)
        field = ll.field((vertices, faces))
        outward = vertices / 2
        self.assertGreater((field["ll_normal"] * outward).sum(axis=1).min(), 0.999)
        traces = field["ll_shape_diagonal"].sum(axis=1)  # 1/R + 1/R
        numpy.testing.assert_allclose(traces, 1, atol=0.1)  # where four edges meet
        inward = (field["ll_laplacian_normal"] * outward).sum(axis=1)  # -2/R²
        numpy.testing.assert_allclose(inward, -0.5, atol=0.06)

    def test_has_the_shapes_of_its_table(self):
        mesh = sphere(steps=3)
        field = ll.field(mesh, curvature_derivatives=True)
        self.assertEqual(list(field), [row.name for row in ll.ATTRIBUTES])
        for row in ll.ATTRIBUTES:
            self.assertEqual(field[row.name].shape, (len(mesh[0]), 3) if row.numbers == 3 else (len(mesh[0]),))
            self.assertEqual(field[row.name].dtype, numpy.float32)
        self.assertEqual(list(ll.field(mesh)), [row.name for row in ll.ATTRIBUTES if not row.optional])

        surface = ll.Surface(mesh, normal_smoothing="none", kernel_size=0.5)
        self.assertEqual(surface.measures()["normal_sigma"], 0)
        self.assertAlmostEqual(surface.measures()["kernel_size"], 0.5)
