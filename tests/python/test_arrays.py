"""Arrays are shared with the library, and refused where they cannot be."""

import gc
import sys
import unittest
import weakref

import numpy
from hair_for_tests import LIGHT, small_groom, small_simulation, wavy

import libhair


class Inputs(unittest.TestCase):
    def test_arrays_of_the_right_type_are_used_in_place(self):
        points = wavy().reshape(-1, 3)
        first = numpy.arange(0, 2401, 12, dtype=numpy.uint32)
        strands = libhair.Strands(points, first)
        self.assertIs(strands.points, points)
        self.assertIs(strands.first, first)

    def test_a_grid_of_points_is_used_in_place(self):
        grid = wavy()
        strands = libhair.Strands(grid)
        self.assertTrue(numpy.shares_memory(strands.points, grid))
        self.assertEqual((len(strands), strands.point_count), (200, 2400))

    def test_what_is_written_later_is_seen(self):
        grid = wavy()
        strands = libhair.Strands(grid)
        before = libhair.shadow(strands, LIGHT)
        grid[:, :, 0] *= 3  # a third as dense
        self.assertGreater(libhair.shadow(strands, LIGHT).mean(), before.mean() + 0.05)

    def test_damage_that_is_written_later_is_refused(self):
        grid = wavy()
        strands = libhair.Strands(grid)
        grid[3, 4, 0] = numpy.nan
        with self.assertRaisesRegex(libhair.Error, "strand 3 point 4"):
            libhair.shadow(strands, LIGHT)
        first = numpy.array([0, 2400], numpy.uint32)
        strands = libhair.Strands(wavy().reshape(-1, 3), first)
        first[1] = 1 << 30
        with self.assertRaisesRegex(libhair.Error, "offsets end at 1073741824"):
            libhair.shadow(strands, LIGHT)

    def test_strands_keep_arrays_that_nobody_else_has(self):
        grid = wavy()
        gone = weakref.ref(grid)
        strands = libhair.Strands(grid)
        total = float(grid.sum())
        del grid
        gc.collect()
        self.assertIsNotNone(gone())
        self.assertEqual(float(strands.points.reshape(200, 12, 3).sum()), total)
        del strands
        gc.collect()
        self.assertIsNone(gone())

    def test_calls_leave_no_references(self):
        points = wavy().reshape(-1, 3)
        first = numpy.arange(0, 2401, 12, dtype=numpy.uint32)
        out = numpy.empty(2400, numpy.float32)
        strands = libhair.Strands(points, first)
        counts = [sys.getrefcount(a) for a in (points, first, out)]
        for _ in range(5):
            libhair.shadow(strands, LIGHT, out=out)
            strands.lengths(), strands[0]
        self.assertEqual([sys.getrefcount(a) for a in (points, first, out)], counts)

    def test_results_are_written_to_out(self):
        strands = libhair.Strands(wavy())
        out = numpy.zeros(2400, numpy.float32)
        self.assertIs(libhair.shadow(strands, LIGHT, out=out), out)
        numpy.testing.assert_array_equal(out, libhair.shadow(strands, LIGHT))

    def test_what_cannot_be_used_is_refused_with_the_way_out(self):
        points, first = wavy().reshape(-1, 3), numpy.arange(0, 2401, 12, dtype=numpy.uint32)
        cases = [
            (TypeError, r"points: float64.*points.astype\(numpy.float32\)", points.astype(float), first),
            (TypeError, r"first: int64.*first.astype\(numpy.uint32\)", points, first.astype(int)),
            (TypeError, r"points: a list.*numpy.asarray", [[0, 0, 0]], first),
            (TypeError, r"points: >f4.*float32", points.astype(">f4"), first),
            (ValueError, r"points: shape \(2400, 2\).*\(N, 3\)", points[:, :2].copy(), first),
            (ValueError, r"points: shape \(2400, 3\).*\(N, M, 3\)", points, None),
            (ValueError, r"points: not C-contiguous.*ascontiguousarray", points[::2], first),
            (ValueError, r"points: not C-contiguous", numpy.asfortranarray(points), first),
        ]
        for error, message, p, f in cases:
            with self.subTest(message), self.assertRaisesRegex(error, message):
                libhair.Strands(p, f)
        strands = libhair.Strands(points, first)
        out = numpy.empty(2400, numpy.float32)
        out.setflags(write=False)
        for error, message, o in [
            (ValueError, "out: read-only", out),
            (ValueError, r"out: shape \(7,\), but \(2400,\)", numpy.empty(7, numpy.float32)),
            (TypeError, "out: float64", numpy.empty(2400)),
        ]:
            with self.subTest(message), self.assertRaisesRegex(error, message):
                libhair.shadow(strands, LIGHT, out=o)

    def test_the_way_out_of_bad_alignment_is_one(self):
        raw = numpy.zeros(4 * 3 * 24 + 1, numpy.uint8)
        points = raw[1:].view(numpy.float32).reshape(-1, 3)
        points[:] = wavy(2).reshape(-1, 3)
        first = numpy.array([0, 12, 24], numpy.uint32)
        with self.assertRaisesRegex(ValueError, "points: not aligned: (numpy.require.*)") as caught:
            libhair.Strands(points, first)
        cure = str(caught.exception).partition("aligned: ")[2]
        aligned = eval(cure, {"numpy": numpy, "points": points})
        self.assertEqual(len(libhair.Strands(aligned, first)), 2)

    def test_an_error_of_the_library_is_a_value_error(self):
        self.assertTrue(issubclass(libhair.Error, ValueError))
        with self.assertRaisesRegex(libhair.Error, "offsets must start with 0"):
            libhair.Strands(numpy.zeros((2, 3), numpy.float32), numpy.array([1, 2], numpy.uint32))

    def test_strands_without_points_are_refused_at_once(self):
        for count in (5, 2**40):  # the second's offsets would fill the memory
            with self.assertRaisesRegex(ValueError, f"{count} strands of no points"):
                libhair.Strands(numpy.empty((count, 0, 3), numpy.float32))

    def test_no_strands_are_strands(self):
        none = libhair.Strands(numpy.zeros((0, 3), numpy.float32), numpy.zeros(1, numpy.uint32))
        self.assertEqual(len(none), 0)
        self.assertEqual(libhair.shadow(none, LIGHT).shape, (0,))


class Results(unittest.TestCase):
    def test_views_of_a_groom_outlive_it(self):
        settings = libhair.style_settings("smooth").replace(strands=20, wisps=4)
        groom = libhair.make_groom(settings)
        views = [groom.guide_points, groom.first, groom.parents, groom.weights, groom.offsets]
        copies = [v.copy() for v in views]
        self.assertTrue(numpy.shares_memory(views[0], groom.guide_points))
        del groom
        gc.collect()
        for view, copy in zip(views, copies):
            numpy.testing.assert_array_equal(view, copy)
            with self.assertRaises(ValueError):
                view[0] = 0

    def test_points_of_a_simulation_follow_its_steps_and_outlive_it(self):
        simulation = small_simulation()
        points = simulation.points
        before = points.copy()
        simulation.step(world_from_head=libhair.Transform(translation=(0.1, 0, 0)))
        self.assertGreater(numpy.abs(points - before).max(), 0.05)
        self.assertTrue(numpy.shares_memory(points, simulation.points))
        self.assertTrue(numpy.shares_memory(points, simulation.strands.points))
        after = points.copy()
        del simulation
        gc.collect()
        numpy.testing.assert_array_equal(points, after)

    def test_views_go_on_showing_what_they_showed_when_the_memory_changes(self):
        simulation = small_simulation()
        simulation.settings.radiance = True
        simulation.step()
        views = [simulation.points, simulation.transmittance, simulation.radiance, simulation.colours]
        copies = [v.copy() for v in views]
        state = simulation.save_state()
        simulation.settings.shade = False
        simulation.settings.lights = [LIGHT, LIGHT, LIGHT]
        simulation.restore_state(state)
        simulation.step()
        simulation.change_groom(small_groom())
        simulation.step()
        del simulation
        gc.collect()
        for view, copy in zip(views, copies):
            numpy.testing.assert_array_equal(view, copy)

    def test_views_of_a_mesh_outlive_it(self):
        mesh = libhair.builtin_head()
        positions, triangles = mesh.positions, mesh.triangles
        total = positions.sum()
        del mesh
        gc.collect()
        self.assertEqual(positions.sum(), total)
        self.assertLess(triangles.max(), len(positions))

    def test_a_strand_is_a_view(self):
        grid = wavy()
        strands = libhair.Strands(grid)
        self.assertTrue(numpy.shares_memory(strands[-1], grid[-1]))
        strands[5][0] = (1, 2, 3)
        numpy.testing.assert_array_equal(grid[5, 0], (1, 2, 3))
        with self.assertRaises(IndexError):
            strands[200]
        self.assertEqual(sum(len(s) for s in strands), 2400)


if __name__ == "__main__":
    unittest.main()
