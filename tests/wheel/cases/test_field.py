# SPDX-License-Identifier: GPL-3.0-or-later
import unittest

import laplacian_lines as ll
import numpy
from shapes import REFERENCE, sphere, torus


class Field(unittest.TestCase):
    def test_signs_on_a_sphere(self):
        vertices, faces = sphere(radius=2)
        field = ll.field((vertices, faces))
        outward = vertices / 2
        self.assertGreater((field["ll_normal"] * outward).sum(axis=1).min(), 0.999)
        traces = field["ll_shape_diagonal"].sum(axis=1)  # 1/R + 1/R
        numpy.testing.assert_allclose(traces, 1, atol=0.05)
        inward = (field["ll_laplacian_normal"] * outward).sum(axis=1)  # -2/R²
        numpy.testing.assert_allclose(inward, -0.5, atol=0.06)

    def test_signs_on_a_torus(self):
        vertices, faces = torus()
        traces = ll.field((vertices, faces))["ll_shape_diagonal"].sum(axis=1)
        distances = numpy.hypot(vertices[:, 0], vertices[:, 1])
        cosines = (distances - 1) / 0.4
        numpy.testing.assert_allclose(traces, 1 / 0.4 + cosines / distances, atol=0.15)

    def test_is_what_the_core_computes_in_a_program_of_its_own(self):
        path = REFERENCE / "torus.txt"
        numbers = numpy.loadtxt(path, dtype=numpy.float32)
        layout = [word.split(":") for word in path.read_text().partition("\n")[0].split()[1:]]
        field = ll.field(str(REFERENCE / "torus.ply"))
        self.assertEqual(list(field), [name for name, _ in layout if not name.startswith("true_")])
        first = 0
        for name, count in layout:
            expected = numbers[:, first : first + int(count)]
            first += int(count)
            if name in field:
                numpy.testing.assert_allclose(field[name].reshape(expected.shape), expected, rtol=0,
                                              atol=1e-5 * numpy.abs(expected).max())

    def test_has_the_shapes_of_its_table(self):
        mesh = sphere(steps=3)
        field = ll.field(mesh, curvature_derivatives=True)
        self.assertEqual(list(field), [row.name for row in ll.ATTRIBUTES])
        for row in ll.ATTRIBUTES:
            self.assertEqual(field[row.name].shape, (len(mesh[0]), 3) if row.numbers == 3 else (len(mesh[0]),))
            self.assertEqual(field[row.name].dtype, numpy.float32)
        self.assertEqual(list(ll.field(mesh)), [row.name for row in ll.ATTRIBUTES if not row.optional])

    def test_options_count(self):
        mesh = sphere(steps=3)
        self.assertAlmostEqual(ll.field(mesh, kernel_size=0.5)["ll_kernel_size"][0], 0.5, places=6)
        surface = ll.Surface(mesh, normal_smoothing="none", kernel_mode=1)
        self.assertEqual(surface.measures()["normal_sigma"], 0)
        self.assertGreater(numpy.ptp(surface.field()["ll_kernel_size"]), 0)

    def test_derivatives_for_lines_do_not_appear_in_the_field(self):
        surface = ll.Surface(torus())
        surface.lines(direction=(1, 1, 1), kinds="suggestive_contours")
        self.assertNotIn("ll_smooth_curvature", surface.field())


if __name__ == "__main__":
    unittest.main()
