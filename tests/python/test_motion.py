"""The built-in dance and recorded clips."""

import pathlib
import tempfile
import unittest

import numpy

import libhair

BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Head
  {
    OFFSET 0 50 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 20 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.5
0 100 0 0 0 0 0 0 0
10 100 0 0 0 0 0 0 0
20 100 0 0 0 0 0 0 0
"""


class Motions(unittest.TestCase):
    def test_the_dance_is_a_loop(self):
        dance = libhair.Motion.dance()
        self.assertTrue(dance.is_loop)
        first, last = dance.pose(0), dance.pose(dance.duration)
        numpy.testing.assert_allclose(first.joints, last.joints, atol=1e-4)
        self.assertEqual(first.capsules.shape[1], 7)
        self.assertEqual(len(first.joints), len(dance.joint_names))
        self.assertGreater(len(dance.body_mesh(first).triangles), 1000)

    def test_nobody_moves_in_still(self):
        still = libhair.Motion.still()
        self.assertEqual(still.duration, 0)
        numpy.testing.assert_array_equal(still.pose(0).joints, still.pose(3).joints)

    def test_a_clip_is_read_in_metres(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.bvh"
            path.write_text(BVH)
            clip = libhair.Motion.read(path)
            larger = libhair.Motion.read(path, scale=0.02, up="z", head_joint="head")
            with self.assertRaisesRegex(libhair.Error, "no joint is called Helm"):
                libhair.Motion.read(path, head_joint="Helm")
            with self.assertRaisesRegex(libhair.Error, "no axis"):
                libhair.Motion.read(path, up="w")
            path.write_text(BVH.replace("Frames: 3", "Frames: x"))
            with self.assertRaisesRegex(libhair.Error, r"a\.bvh"):
                libhair.Motion.read(path)
        self.assertEqual(clip.duration, 1)
        numpy.testing.assert_allclose(clip.pose(1).joints[0], [0.2, 1, 0], atol=1e-6)
        self.assertIn("0.01 m per unit, +Y up, head joint Head", clip.notes[0])
        numpy.testing.assert_allclose(larger.pose(1).joints[0], [0.4, 0, -2], atol=1e-6)

    def test_a_pose_is_made_by_hand(self):
        pose = libhair.Pose(libhair.Transform(translation=(0, 1, 0)), [[0, 0, 0, 0, 1, 0, 0.1]])
        self.assertEqual(pose.capsules.shape, (1, 7))
        self.assertEqual(pose.world_from_head.translation, (0, 1, 0))


if __name__ == "__main__":
    unittest.main()
