"""Blender's space and libhair's."""

import unittest

import numpy
from mathutils import Euler, Matrix

from scene_for_tests import *


class Axes(unittest.TestCase):
    def setUp(self):
        from libhair_blender import axes

        self.axes = axes

    def test_up_stays_up_and_the_face_looks_to_the_front(self):
        # Of a face that looks at Blender's front view (-Y), left is +X in both.
        axes = numpy.array([[0, 0, 1], [0, -1, 0], [1, 0, 0]], numpy.float32)
        wanted = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]
        self.assertEqual(self.axes.to_libhair(axes).tolist(), wanted)

    def test_there_and_back_is_exact(self):
        points = numpy.random.default_rng(1).normal(size=(1000, 3)).astype(numpy.float32)
        there = self.axes.to_libhair(points)
        self.assertEqual(there.dtype, numpy.float32)
        self.assertEqual(self.axes.from_libhair(there).tobytes(), points.tobytes())
        self.assertEqual(self.axes.from_libhair(self.axes.to_libhair(points, 0.25), 0.25).tobytes(),
                         points.tobytes())

    def test_a_place_moves_points_as_its_matrix_does(self):
        matrix = Matrix.LocRotScale((1, 2, 3), Euler((0.3, -1, 2)), (2, 1, 0.5))
        points = numpy.random.default_rng(2).normal(size=(100, 3))
        for scale in (1.0, 0.01):
            moved = self.axes.to_libhair(self.axes.move(matrix, points), scale)
            there = self.axes.move(
                self.axes.place(matrix, scale), self.axes.to_libhair(points, scale)
            )
            self.assertLess(numpy.abs(moved - there).max(), 1e-12)

    def test_a_turn_of_space_is_no_mirror(self):
        self.assertEqual(round(numpy.linalg.det(self.axes.TURN[:3, :3])), 1)


run(Axes)
