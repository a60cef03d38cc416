# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other packages are taken as they are, where these packages are installed."""

import importlib.util
import unittest

import laplacian_lines as ll
import numpy
from shapes import REFERENCE, torus


def package(name):
    if importlib.util.find_spec(name) is None:
        raise unittest.SkipTest(f"{name} is not here")
    return importlib.import_module(name)


class OtherPackages(unittest.TestCase):
    def expect_same(self, mesh, given=None):
        vertices, faces = given or torus()
        found = ll.as_arrays(mesh)
        numpy.testing.assert_allclose(found[0], vertices, atol=1e-6)
        numpy.testing.assert_array_equal(found[1], faces)
        self.assertGreater(len(ll.visible_lines(mesh, direction=(0, 0, 1))), 1)

    def test_arrays_of_any_kind(self):
        vertices, faces = torus()
        self.expect_same((vertices.astype(numpy.float32), faces.astype(numpy.int32)))
        self.expect_same([vertices.tolist(), faces.tolist()])
        self.expect_same((numpy.asfortranarray(vertices), faces[:, ::1].astype(numpy.uint64)))

    def test_trimesh(self):
        trimesh = package("trimesh")
        mesh = trimesh.Trimesh(*torus(), process=False)
        self.expect_same(mesh)
        with self.assertRaisesRegex(TypeError, r"to_mesh\(\)"):
            ll.field(trimesh.Scene([mesh]))

    def test_pyvista(self):
        pyvista = package("pyvista")
        vertices, faces = torus()
        mesh = pyvista.PolyData(vertices, numpy.insert(faces, 0, 3, axis=1).ravel())
        self.expect_same(mesh)
        quads = pyvista.Plane(i_resolution=3, j_resolution=3)
        self.assertEqual(ll.as_arrays(quads)[1].shape, (18, 3))
        strip = pyvista.PolyData(vertices[:5], [3, 0, 1, 2], strips=[4, 1, 2, 3, 4])
        self.assertEqual(ll.as_arrays(strip)[1].shape, (3, 3))
        with self.assertRaisesRegex(TypeError, r"extract_surface\(\)"):
            ll.field(pyvista.ImageData(dimensions=(3, 3, 3)))

    def test_pymeshlab(self):
        pymeshlab = package("pymeshlab")
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*torus()))
        self.expect_same(meshes.current_mesh())
        self.expect_same(meshes)

    def test_files(self):
        self.expect_same(REFERENCE / "torus.ply", ll.read_mesh(REFERENCE / "torus.ply"))
