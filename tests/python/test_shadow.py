"""Shadows keep the laws of light, whichever way they are asked for."""

import unittest

import numpy
from hair_for_tests import LIGHT, wavy

import libhair

FIBRE = libhair.Fibre(width=80e-6, opacity=0.6, hairs_per_strand=1)


def slab(strands=6000, depth=0.1, side=0.1, seed=1):
    """Strands along x, spread evenly over a slab that light along z falls on."""
    random = numpy.random.default_rng(seed)
    points = numpy.empty((strands, 2, 3), numpy.float32)
    points[:, :, 1:] = random.random((strands, 1, 2)) * [side, depth]
    points[:, :, 0] = [0, side]
    return points


class Laws(unittest.TestCase):
    def test_light_falls_off_in_a_slab_as_beer_says(self):
        depth, side = 0.1, 0.1
        hair = libhair.Strands(slab(depth=depth, side=side))
        z = numpy.linspace(0, depth, 21, dtype=numpy.float32)
        at = numpy.array([(x, y, d) for d in z for x in (0.04, 0.05, 0.06)
                          for y in numpy.linspace(0.03, 0.07, 5)], numpy.float32)
        seen = libhair.shadow(hair, libhair.Light.parallel((0, 0, 1)), fibre=FIBRE, at=at)
        seen = seen.reshape(21, -1).mean(axis=1)
        # Each fibre takes 0.6 of the light that meets its width.
        per_metre = len(hair) * FIBRE.width * FIBRE.opacity / (side * depth)
        # At the face of the slab the footprint reaches out of it.
        numpy.testing.assert_allclose(seen[1:], numpy.exp(-per_metre * z[1:]), atol=0.03)

    def test_transmittance_is_between_0_and_1(self):
        hair = libhair.Strands(wavy(3000))
        for method in all_methods():
            t = libhair.shadow(hair, LIGHT, method=method)
            self.assertTrue((t >= 0).all() and (t <= 1).all(), method)
            self.assertLess(t.min(), 0.5, method)

    def test_a_light_far_away_is_parallel_light(self):
        hair = libhair.Strands(wavy(10000))
        towards = numpy.array([-0.45, 0.8, 0.4])
        lamp = libhair.Light.point(hair.points.mean(axis=0) + 500 * towards)
        far = libhair.shadow(hair, lamp, fibre=FIBRE)
        parallel = libhair.shadow(hair, LIGHT, fibre=FIBRE)
        self.assertLess(numpy.abs(far - parallel).mean(), 0.01)

    def test_strands_share_the_hairs_of_a_head(self):
        hair = libhair.Strands(wavy(500))
        shared = libhair.shadow(hair, LIGHT)
        numpy.testing.assert_array_equal(
            shared, libhair.shadow(hair, LIGHT, fibre=libhair.Fibre(hairs_per_strand=200)))
        self.assertEqual(libhair.bind_groom(hair).fibre.hairs_per_strand, 200)

    def test_no_hair_is_no_shadow(self):
        hair = libhair.Strands(wavy())
        above = numpy.array([[0, 5, 0]], numpy.float32)
        self.assertEqual(libhair.shadow(hair, LIGHT, at=above)[0], 1)


def all_methods():
    return [libhair.DensityMapSettings(), libhair.ShadowMapSettings(),
            libhair.OpacityMapSettings(), libhair.DeepOpacityMapSettings(),
            libhair.DensityClusteringSettings(), libhair.DeepShadowMapSettings()]


class Doors(unittest.TestCase):
    def test_one_call_is_build_and_sample(self):
        hair = libhair.Strands(wavy(500))
        for settings in all_methods():
            method = libhair.ShadowMethod(settings)
            with self.assertRaisesRegex(libhair.Error, "nothing was built"):
                method.sample(hair.points)
            method.build(hair, LIGHT)
            one = libhair.shadow(hair, LIGHT, method=settings)
            numpy.testing.assert_array_equal(method.sample_strands(hair), one)
            self.assertGreater(method.bytes, 0)
            self.assertEqual(method.settings, settings)

    def test_the_density_map_pass_by_pass_is_the_same(self):
        hair = libhair.Strands(wavy(500))
        settings = libhair.DensityMapSettings(cells=128, cell_size=6e-3)
        density = libhair.DensityMap(settings, LIGHT)
        density.deposit(hair)
        with self.assertRaises(libhair.Error):
            density.sample(hair.points)
        density.compute_transmittance()
        numpy.testing.assert_array_equal(density.sample_strands(hair),
                                         libhair.shadow(hair, LIGHT, method=settings))
        self.assertFalse(density.empty or density.aliased)
        density.clear()
        self.assertTrue(density.empty)

    def test_the_grid_holds_all_the_hair(self):
        hair = libhair.Strands(wavy(500))
        settings = libhair.DensityGridSettings(cells=128, cell_size=6e-3)
        density = libhair.DensityGrid(settings)
        density.deposit(hair)
        grid = density.density_grid()
        self.assertEqual(grid.shape, tuple(numpy.subtract(density.upper, density.lower) + 1))
        self.assertEqual(density.cell_centres().shape, grid.shape + (3,))
        metres = grid.sum(dtype=float) * settings.cell_size**3
        self.assertAlmostEqual(metres / hair.lengths().sum(), 1, places=2)
        somewhere = numpy.unravel_index(grid.argmax(), grid.shape)
        place = density.cell_centres()[somewhere][None]
        self.assertAlmostEqual(density.density(place)[0][0] / grid[somewhere], 1, places=4)

    def test_opaque_things_darken_what_is_behind(self):
        hair = libhair.Strands(wavy(50))
        behind = numpy.array([[0.1, 0.5, 0.1]], numpy.float32)
        light = libhair.Light.parallel((0, -1, 0))
        density = libhair.DensityMap(libhair.DensityMapSettings(), light)
        density.deposit(hair)
        density.occlude_capsules([[0, 0.85, 0.1, 0.2, 0.85, 0.1, 0.05]])
        density.compute_transmittance()
        self.assertLess(density.sample(behind)[0], 0.01)

    def test_colours_are_darker_in_shadow(self):
        hair = libhair.Strands(wavy(500))
        shadow = libhair.shadow(hair, LIGHT)
        lit = libhair.shade(hair, [LIGHT])
        dark = libhair.shade(hair, [LIGHT], transmittance=shadow[None])
        self.assertEqual((lit.shape, lit.dtype), ((6000, 3), numpy.float32))
        self.assertTrue((dark <= lit).all())
        self.assertLess(dark.mean(), 0.8 * lit.mean())
        out = numpy.empty_like(lit)
        self.assertIs(libhair.shade(hair, [LIGHT], out=out), out)
        numpy.testing.assert_array_equal(out, lit)
        # Light is linear and has no upper end.
        bright = libhair.shade(hair, [libhair.Light.parallel(LIGHT.direction, (20, 20, 20))])
        none = libhair.shade(hair, [])
        numpy.testing.assert_allclose(bright - none, 20 * (lit - none), rtol=1e-4, atol=1e-5)
        self.assertGreater(bright.max(), 1)

    def test_bytes_are_made_of_radiance(self):
        hair = libhair.Strands(wavy(500))
        radiance = libhair.shade(hair, [LIGHT])
        colours = libhair.encode_srgb(radiance)
        self.assertEqual((colours.shape, colours.dtype), ((6000, 4), numpy.uint8))
        self.assertTrue((colours[:, 3] == 255).all())
        x = radiance.clip(0, 1)
        shown = numpy.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
        self.assertLess(numpy.abs(255 * shown - colours[:, :3]).max(), 0.75)
        weights = numpy.linspace(0, 1, 500, dtype=numpy.float32)
        out = numpy.empty_like(colours)
        self.assertIs(libhair.encode_srgb(radiance, strands=hair, weights=weights, out=out), out)
        numpy.testing.assert_array_equal(out[:, :3], colours[:, :3])
        self.assertLess(numpy.abs(out[::12, 3] / 255 - weights).max(), 0.003)
        with self.assertRaisesRegex(ValueError, "strands is None"):
            libhair.encode_srgb(radiance, weights=weights)
        with self.assertRaisesRegex(ValueError, "weights: shape"):
            libhair.encode_srgb(radiance, strands=hair, weights=weights[1:])
        with self.assertRaisesRegex(ValueError, "strands: 6000 points"):
            libhair.encode_srgb(radiance[1:], strands=hair, weights=weights)
        with self.assertRaisesRegex(libhair.Error, "weights: strand 250"):
            libhair.encode_srgb(radiance, strands=hair, weights=2 * weights)

    def test_points_that_are_no_numbers_are_refused(self):
        hair = libhair.Strands(wavy())
        at = numpy.full((1, 3), numpy.nan, numpy.float32)
        with self.assertRaisesRegex(libhair.Error, "at: point 0"):
            libhair.shadow(hair, LIGHT, at=at)
        for footprint in (0, -1, numpy.nan):
            with self.assertRaisesRegex(libhair.Error, "footprint"):
                libhair.shadow(hair, LIGHT, footprint)


if __name__ == "__main__":
    unittest.main()
