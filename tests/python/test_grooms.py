"""Hair at rest: styles, strands of one's own, hair meshes, arrays."""

import os
import pathlib
import unittest

import numpy
from hair_for_tests import head_field, small_groom, wavy

import libhair

MODELS = pathlib.Path(os.environ["HAIR_SOURCE_DIR"]) / "models"


class Grooms(unittest.TestCase):
    def test_every_style_grows(self):
        for style in ("smooth", "curly", "long"):
            settings = libhair.style_settings(style).replace(strands=100, wisps=10)
            groom = libhair.make_groom(settings, head_field())
            self.assertEqual((groom.strand_count, groom.guide_count), (100, 30))
            self.assertGreater(head_field().distance(groom.guide_points[:, -1].copy()).min(), 0)
        with self.assertRaisesRegex(ValueError, "'bald' is none of"):
            libhair.make_groom("bald")

    def test_bound_strands_are_where_they_were(self):
        strands = libhair.Strands(wavy(300))
        groom = libhair.bind_groom(strands, libhair.BindSettings(guides=30))
        self.assertEqual((groom.guide_count, groom.strand_count), (30, 300))
        simulation = libhair.Simulation(groom)
        numpy.testing.assert_allclose(simulation.points, strands.points, atol=1e-4)
        simulation.run(3)

    def test_a_groom_from_arrays_is_that_groom(self):
        groom = small_groom()
        again = libhair.Groom(groom.guide_points, groom.first, groom.parents, groom.weights,
                              groom.offsets, fibre=groom.fibre)
        self.assertEqual(libhair.Simulation(again).state_hash(),
                         libhair.Simulation(groom).state_hash())

    def test_grooms_that_cannot_be_are_refused(self):
        groom = small_groom()
        given = {n: getattr(groom, n).copy() for n in ("guide_points", "first", "parents", "weights")}
        parents = given["parents"].copy()
        parents[3, 1] = 1 << 20
        offsets = numpy.zeros((5, 3), numpy.float32)
        first = given["first"].copy()
        first[4] = first[2]
        for changed in ({"parents": parents}, {"weights": 2 * given["weights"]},
                        {"offsets": offsets}, {"first": first},
                        {"guide_points": given["guide_points"] * numpy.float32(numpy.nan)},
                        {"first": numpy.zeros(0, numpy.uint32)},
                        {"guide_points": given["guide_points"][:, :1].copy()}):
            with self.subTest(list(changed)), self.assertRaises(ValueError):
                libhair.Groom(**{**given, **changed})

    def test_a_hair_mesh_is_a_groom(self):
        if not libhair.has_hair_mesh:
            self.skipTest("built without hair meshes")
        groom = libhair.hair_mesh_groom(MODELS / "bob.hairmesh", strands=500)
        self.assertEqual(groom.strand_count % 500, 0)
        libhair.Simulation(groom).run(2)


if __name__ == "__main__":
    unittest.main()
