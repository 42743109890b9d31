"""Places, meshes and distances."""

import unittest

import numpy
from hair_for_tests import head_field, wavy

import libhair


class Transforms(unittest.TestCase):
    def test_a_matrix_and_its_transform_are_the_same(self):
        turn = libhair.Transform(rotation=(0.5, 0.5, 0.5, 0.5), translation=(1, 2, 3))
        numpy.testing.assert_allclose(turn.matrix, [[0, 0, 1, 1], [1, 0, 0, 2], [0, 1, 0, 3],
                                                    [0, 0, 0, 1]], atol=1e-7)
        again = libhair.Transform(turn.matrix)
        numpy.testing.assert_allclose(again.rotation, turn.rotation, atol=1e-7)
        numpy.testing.assert_allclose((turn.inverse() @ turn).matrix, numpy.eye(4), atol=1e-6)

    def test_points_are_turned_and_moved(self):
        points = wavy(10).reshape(-1, 3)
        turn = libhair.Transform(rotation=(0.8, 0, 0.6, 0), translation=(0, 1, 0))
        expected = points @ turn.matrix[:3, :3].T + turn.matrix[:3, 3]
        numpy.testing.assert_allclose(turn.apply(points), expected, atol=1e-6)

    def test_what_scales_is_refused(self):
        for matrix in (numpy.diag([2, 2, 2, 1]), numpy.diag([1, 1, -1, 1]), numpy.diag([0, 0, 0, 1])):
            with self.assertRaisesRegex(ValueError, "not only a turn and a move|mirrors"):
                libhair.Transform(matrix)
        with self.assertRaisesRegex(ValueError, r"\(4, 4\)"):
            libhair.Transform(numpy.eye(3))

    def test_a_move_in_the_last_row_and_a_mirror_are_refused(self):
        moved = numpy.eye(4)
        moved[3, 0] = 1
        with self.assertRaisesRegex(ValueError, "matrix.T"):
            libhair.Transform(moved)
        self.assertEqual(libhair.Transform(moved.T).translation, (1, 0, 0))
        with self.assertRaisesRegex(ValueError, "mirrors"):
            libhair.Transform(numpy.diag([1.0, 1, -1, 1]))

    def test_what_is_not_finite_is_refused(self):
        for bad in (float("nan"), float("inf")):
            matrix = numpy.eye(4)
            matrix[1, 3] = bad
            for place in ({"rotation": (bad, 0, 0, 0)}, {"translation": (0, bad, 0)},
                          {"matrix": matrix}):
                with self.subTest(place), self.assertRaisesRegex(ValueError, "rotation|translation"):
                    libhair.Transform(**place)


class Distances(unittest.TestCase):
    def test_a_field_knows_inside_from_outside(self):
        head = libhair.builtin_head()
        surface = head_field().distance(head.positions)
        self.assertLess(numpy.abs(surface).mean(), 5e-4)
        at = numpy.array([[0, 0.1, 0], [0, 1, 0]], numpy.float32)
        inside, outside = head_field().distance(at)
        self.assertLess(inside, -0.05)
        self.assertGreater(outside, 0.5)

    def test_meshes_that_are_none_are_refused(self):
        points = numpy.zeros((3, 3), numpy.float32)
        with self.assertRaisesRegex(ValueError, "vertex 3 of only 3"):
            libhair.Mesh(points, numpy.array([[0, 1, 3]], numpy.uint32))
        with self.assertRaisesRegex(TypeError, "triangles: int64"):
            libhair.Mesh(points, numpy.array([[0, 1, 2]]))
        with self.assertRaises(libhair.Error):
            libhair.DistanceField(libhair.Mesh(points[:0], numpy.zeros((0, 3), numpy.uint32)))

    def test_a_head_is_fitted_to_roots(self):
        roots = libhair.make_groom(libhair.style_settings().replace(strands=400, wisps=40),
                                   head_field()).guide_points[:, 0].copy()
        moved = roots + numpy.float32([0, 1.5, 0])
        fit = libhair.fit_head(moved)
        self.assertLess(fit.residual, 5e-3)
        numpy.testing.assert_allclose(fit.transform.apply(moved), roots, atol=0.02)
        self.assertGreater(len(fit.mesh.triangles), 100)
        self.assertIsInstance(libhair.place_head(fit.mesh, moved), libhair.Transform)


if __name__ == "__main__":
    unittest.main()
