"""Files of strands and meshes, read and written through the library's own calls."""

import os
import pathlib
import tempfile
import unittest

import numpy
from hair_for_tests import wavy

import libhair

MODELS = pathlib.Path(os.environ["HAIR_SOURCE_DIR"]) / "models"


def file_notes(path):
    return " ".join(libhair.read_strands(path).notes)


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
        with self.assertRaisesRegex(ValueError, "'north' is none of: file, y"):
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
        turned = libhair.read_obj(path, scale=0.01, up="z-back")
        numpy.testing.assert_allclose(turned.positions[3], [0.01, 0, -0.01], atol=1e-8)
        numpy.testing.assert_allclose(turned.normals, [[0, 1, 0]] * 4, atol=1e-7)

    def test_strands_of_numpy_are_read(self):
        points = wavy(30)
        numpy.save(self.folder / "a.npy", points)
        numpy.savez(self.folder / "b.npz", points=points.astype("f8"), note=numpy.array("text"))
        counts = numpy.full(len(points), points.shape[1])
        numpy.savez_compressed(self.folder / "c.npz", points=points.reshape(-1, 3), counts=counts)
        numpy.save(self.folder / "d.npy", numpy.asfortranarray(points.astype(">f4")))
        numpy.save(self.folder / "e.npy", points.reshape(-1, 3))
        for name in ("a.npy", "b.npz", "c.npz", "d.npy"):
            file = libhair.read_strands(self.folder / name)
            numpy.testing.assert_array_equal(file.strands.points, points.reshape(-1, 3), name)
            self.assertEqual(len(file.strands), 30, name)
        self.assertIn("points, counts are read", file_notes(self.folder / "c.npz"))
        cloud = libhair.read_strands(self.folder / "e.npy", points_per_strand=points.shape[1])
        self.assertEqual(len(cloud.strands), 30)
        with self.assertRaisesRegex(libhair.Error, "objects"):
            numpy.save(self.folder / "f.npy", numpy.array([points[0], points[1, :3]], dtype=object))
            libhair.read_strands(self.folder / "f.npy")

    def test_a_groom_is_loaded_with_its_head(self):
        head = libhair.builtin_head()
        normals = head.normals[::50]
        roots = head.positions[::50][head.positions[::50][:, 1] > 0.1]
        up = normals[head.positions[::50][:, 1] > 0.1]
        points = roots[:, None] + numpy.linspace(0, 0.2, 12, dtype="f4")[None, :, None] * up[:, None]
        libhair.write_strands(self.folder / "a.ply", libhair.Strands(points.astype("f4")))
        loaded = libhair.load_groom(self.folder / "a.ply", settings=libhair.BindSettings(guides=20))
        self.assertEqual(loaded.groom.strand_count, len(points))
        self.assertIn("no --head", " ".join(loaded.notes))
        self.assertAlmostEqual(loaded.groom.fibre.hairs_per_strand, 1e5 / len(points), delta=1)
        path = self.folder / "head.obj"
        with path.open("w") as out:
            for x, y, z in 100 * head.positions:
                out.write(f"v {x} {y} {z}\n")
            for a, b, c in head.triangles + 1:
                out.write(f"f {a} {b} {c}\n")
        try:
            loaded = libhair.load_groom(self.folder / "a.ply", [path], head_scale=0.01)
        except libhair.Error as error:
            if "built without" in str(error):
                self.skipTest(str(error))
            raise
        self.assertAlmostEqual(float(numpy.ptp(loaded.head.positions[:, 0])),
                               float(numpy.ptp(head.positions[:, 0])), delta=1e-3)
        with self.assertRaisesRegex(libhair.Error, "--head-scale 0.01 --head-up y"):
            libhair.load_groom(self.folder / "a.ply", [path])


if __name__ == "__main__":
    unittest.main()
