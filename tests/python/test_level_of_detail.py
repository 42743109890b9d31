"""Levels of detail: less is drawn, guides do not feel it, and older views stay what they were."""

import math
import unittest

import numpy
from hair_for_tests import small_groom, small_simulation

import libhair

SMALL = libhair.LevelOfDetail(strands=0.25, points=0.6)


class Levels(unittest.TestCase):
    def test_a_small_head_is_drawn_with_less_and_as_much_area(self):
        simulation = small_simulation()
        covered = simulation.strands.lengths().sum()
        self.assertEqual(simulation.wider, 1)
        simulation.level = SMALL
        self.assertEqual(simulation.level, SMALL)
        self.assertEqual(simulation.points.shape[0], small_groom().point_count)  # until it is drawn
        simulation.light()
        points, first = simulation.points, simulation.first
        self.assertEqual(first.shape, (121,))
        self.assertEqual(first[-1], len(points))
        self.assertEqual(simulation.transmittance.shape, (1, len(points)))
        self.assertEqual(simulation.colours.shape, (len(points), 4))
        drawn = numpy.flatnonzero(numpy.diff(first))
        self.assertTrue(numpy.all(simulation.detail.rank[drawn] < 0.25 * 1.25 + 1e-6))
        self.assertTrue(20 < len(drawn) < 60, len(drawn))
        lengths = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
        starts = first[1:][numpy.diff(first) > 0]
        lengths[starts[:-1] - 1] = 0  # from a tip to the next root
        weights = simulation.colours[:-1, 3] / 255
        self.assertAlmostEqual((lengths * weights).sum() * simulation.wider / covered, 1, delta=0.02)

    def test_guides_do_not_feel_the_level(self):
        motion = libhair.Motion.dance()
        whole, changing = small_simulation(), small_simulation()
        for i in range(12):
            pose = motion.pose((i + 1) / 60)
            changing.level = libhair.LevelOfDetail(strands=(i % 3 + 1) / 3)
            changing.step(pose=pose)
            whole.step(pose=pose)
        changing.level = libhair.LevelOfDetail()
        changing.light()
        self.assertEqual(changing.state_hash(), whole.state_hash())

    def test_older_views_show_what_they_last_did(self):
        simulation = small_simulation()
        for level in (SMALL, libhair.LevelOfDetail(strands=0.5), SMALL, libhair.LevelOfDetail()):
            names = ("points", "first", "transmittance", "colours")
            views = [getattr(simulation, name) for name in names]
            copies = [view.copy() for view in views]
            simulation.level = level
            simulation.step()
            for view, copy in zip(views, copies):
                numpy.testing.assert_array_equal(view, copy)
            self.assertEqual(simulation.first[-1], len(simulation.points))

    def test_another_groom_starts_whole(self):
        simulation = small_simulation()
        simulation.level = SMALL
        simulation.step()
        simulation.change_groom(small_groom())
        self.assertEqual(simulation.level, libhair.LevelOfDetail())
        self.assertIsNone(simulation.detail)
        self.assertEqual(simulation.wider, 1)

    def test_levels_grow_with_the_head(self):
        detail = libhair.GroomDetail(small_groom())
        pixels = libhair.head_pixels(2, 0.5, 1080)
        self.assertAlmostEqual(pixels, 1080 * 0.225 / (4 * math.tan(0.25)), places=3)
        self.assertEqual(libhair.level_for(detail, pixels).strands, 1)
        small = libhair.level_for(detail, 2)
        self.assertAlmostEqual(small.strands, 80 / 120, places=5)
        self.assertEqual(libhair.level_for(detail, 4, importance=0.5), small)
        few = libhair.level_for(detail, 2, settings=libhair.DetailSettings(strands_per_pixel=20))
        self.assertAlmostEqual(few.strands, 40 / 120, places=5)

    def test_a_groom_of_a_level_is_as_much_hair(self):
        groom = small_groom()
        detail = libhair.GroomDetail(groom)
        few = libhair.groom_at(groom, detail, SMALL)
        self.assertLess(few.strand_count, 0.35 * groom.strand_count)
        self.assertGreater(few.fibre.hairs_per_strand, 3 * groom.fibre.hairs_per_strand)

    def test_refuses_what_is_no_level(self):
        detail = libhair.GroomDetail(small_groom())
        for pixels in (0, -1, math.nan, math.inf):
            with self.assertRaisesRegex(libhair.Error, "pixels high"):
                libhair.level_for(detail, pixels)
        with self.assertRaisesRegex(libhair.Error, "importance"):
            libhair.level_for(detail, 100, importance=2)
        simulation = small_simulation()
        with self.assertRaisesRegex(libhair.Error, "strands"):
            simulation.level = libhair.LevelOfDetail(strands=0)
        self.assertEqual(simulation.level, libhair.LevelOfDetail())
        other = libhair.make_groom(libhair.style_settings("smooth").replace(strands=60, wisps=6))
        with self.assertRaisesRegex(libhair.Error, "another|strands"):
            simulation.detail = libhair.GroomDetail(other)
