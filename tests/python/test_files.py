"""Files of strands and meshes, read and written through the library's own calls."""

import os
import pathlib
import tempfile
import unittest

import numpy
from hair_for_tests import wavy

import libhair

MODELS = pathlib.Path(os.environ["HAIR_SOURCE_DIR"]) / "models"


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_what_is_written_is_read_bit_for_bit(self):
        strands = libhair.Strands(wavy())
        for path in (self.folder / "a.hair", str(self.folder / "b.hair")):
            libhair.write_strands(path, strands)
            back = libhair.read_strands(path)
            numpy.testing.assert_array_equal(back.strands.points, strands.points)
            numpy.testing.assert_array_equal(back.strands.first, strands.first)
            self.assertEqual((back.format, back.scale, back.up), ("hair", 1, "y"))

    def test_a_read_file_is_written_with_its_arrays(self):
        file = libhair.read_strands(MODELS / "smooth.hair")
        libhair.write_strands(self.folder / "again.hair", file)
        again = libhair.read_strands(self.folder / "again.hair")
        numpy.testing.assert_array_equal(again.strands.points, file.strands.points)
        self.assertEqual(again.default_thickness, file.default_thickness)
        self.assertEqual(again.thickness is None, file.thickness is None)

    def test_moving_strands_go_into_one_file_or_many(self):
        still = wavy()
        frames = [still + numpy.float32(0.01) * f for f in range(3)]
        for name in ("shot.usda", "shot.####.ply"):
            with libhair.StrandSequenceWriter(self.folder / name, fps=24, first_frame=7) as writer:
                for points in frames:
                    writer.add(libhair.Strands(points))
            with self.assertRaisesRegex(ValueError, "closed"):
                writer.add(libhair.Strands(still))
        last = libhair.read_strands(self.folder / "shot.0009.ply").strands.points
        numpy.testing.assert_array_equal(last.reshape(frames[2].shape), frames[2])
        self.assertIn("\n        9: [", self.folder.joinpath("shot.usda").read_text())
        with self.assertRaisesRegex(ZeroDivisionError, "."):
            with libhair.StrandSequenceWriter(self.folder / "none.usda") as writer:
                writer.add(libhair.Strands(still))
                1 / 0
        self.assertEqual(len(list(self.folder.iterdir())), 4)
        with self.assertRaisesRegex(libhair.Error, "one frame"):
            libhair.StrandSequenceWriter(self.folder / "still.hair")

    def test_units_and_axes_are_converted(self):
        strands = libhair.Strands(wavy())
        libhair.write_strands(self.folder / "a.hair", strands)
        turned = libhair.read_strands(self.folder / "a.hair", scale=0.01, up="z").strands
        x, y, z = strands.points.T
        numpy.testing.assert_allclose(turned.points.T, 0.01 * numpy.array([-x, z, y]), rtol=1e-6)

    def test_errors_name_file_and_cause(self):
        (self.folder / "no.hair").write_bytes(b"HAIRnothing")
        with self.assertRaisesRegex(libhair.Error, "no.hair"):
            libhair.read_strands(self.folder / "no.hair")
        with self.assertRaisesRegex(libhair.Error, "unknown format"):
            libhair.read_strands(self.folder / "no.such")
        with self.assertRaisesRegex(ValueError, "'north' is none of 'file', 'y'"):
            libhair.read_strands(MODELS / "smooth.hair", up="north")
        with self.assertRaises(TypeError):
            libhair.read_strands(3)

    def test_strands_are_thinned_and_resampled(self):
        strands = libhair.Strands(wavy())
        few = strands.resampled(50, 7)
        self.assertEqual((len(few), few.point_count), (50, 350))
        self.assertTrue(numpy.isin(few.roots()[:, 0], strands.roots()[:, 0]).all())
        grid = wavy(10)
        grid[4] = grid[4, 0]
        self.assertEqual(len(libhair.Strands(grid).without_degenerate()), 9)

    def test_an_obj_is_a_mesh(self):
        path = self.folder / "a.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n")
        try:
            mesh = libhair.read_obj(path)
        except libhair.Error as error:
            if "built without" in str(error):
                self.skipTest(str(error))
            raise
        self.assertEqual((mesh.positions.shape, mesh.triangles.shape), ((4, 3), (2, 3)))
        numpy.testing.assert_allclose(mesh.normals, [[0, 0, 1]] * 4)


if __name__ == "__main__":
    unittest.main()
