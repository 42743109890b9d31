"""Frames: the same bits as the C++ program's, saved and restored, on a body that moves."""

import os
import pathlib
import re
import subprocess
import unittest

import numpy
from hair_for_tests import LIGHT, head_field, small_groom, small_simulation

import libhair


class Frames(unittest.TestCase):
    def test_frames_are_counted_from_none(self):
        simulation = small_simulation()
        self.assertEqual(simulation.run(0), 0)
        with self.assertRaisesRegex(libhair.Error, "frames: -5"):
            simulation.run(-5)

    def test_bits_do_not_depend_on_threads(self):
        hashes = set()
        for threads in (1, 2, 5):
            with libhair.thread_limit(threads):
                simulation = small_simulation()
                simulation.run(20, motion=libhair.Motion.dance())
                hashes.add(simulation.state_hash())
        self.assertEqual(len(hashes), 1)

    def test_a_dance_has_the_bits_of_the_program(self):
        program = pathlib.Path(os.environ["HAIR_BUILD_DIR"]) / "bin" / "hair"
        if not program.exists():
            self.skipTest(f"{program} is not built")
        said = subprocess.run([program, "simulate", "--frames", "20", "--hash"],
                              capture_output=True, text=True)
        found = re.search(r"\b[0-9a-f]{16}\b", said.stdout)
        self.assertTrue(found, said.stdout + said.stderr)
        groom, motion = libhair.make_groom("smooth", head_field()), libhair.Motion.dance()
        frame = libhair.fit_map(libhair.FrameSettings(lights=[LIGHT]), groom)
        simulation = libhair.Simulation(groom, frame, head=head_field(), pose=motion.pose(0))
        simulation.restart()
        for i in range(20):
            simulation.step(1 / 60, pose=motion.pose((i + 1) / 60))
        self.assertEqual(simulation.state_hash(), found[0])

    def test_a_restored_state_goes_on_bit_for_bit(self):
        motion = libhair.Motion.dance()
        simulation = small_simulation()
        simulation.run(5, motion=motion)
        state = simulation.save_state()
        self.assertIsInstance(state, bytes)
        simulation.run(5, motion=motion)
        later = simulation.state_hash()
        other = small_simulation()
        other.restore_state(state)
        self.assertAlmostEqual(other.time, 5 / 60, places=6)
        other.run(5, motion=motion)
        self.assertEqual(other.state_hash(), later)

    def test_damaged_states_are_refused_and_change_nothing(self):
        simulation = small_simulation()
        simulation.run(2)
        state, before = bytearray(simulation.save_state()), simulation.state_hash()
        state[-20] ^= 1
        for damaged in (bytes(state), bytes(state[:100]), b""):
            with self.assertRaises(libhair.Error):
                simulation.restore_state(damaged)
        self.assertEqual(simulation.state_hash(), before)

    def test_hair_hangs_still_where_nothing_moves(self):
        simulation = small_simulation()
        simulation.restart(1)
        before = simulation.points.copy()
        simulation.run(10)
        self.assertLess(numpy.abs(simulation.points - before).max(), 2e-3)
        self.assertLess(simulation.stats()["stretch_max"], 1e-4)

    def test_roots_move_with_the_head(self):
        simulation = small_simulation()
        roots = simulation.strands.roots()
        turn = libhair.Transform(rotation=(0.8, 0, 0.6, 0), translation=(0, 0.2, 0))
        simulation.teleport(turn)
        simulation.step(world_from_head=turn)
        numpy.testing.assert_allclose(simulation.strands.roots(), turn.apply(roots), atol=2e-3)

    def test_a_transform_may_be_a_matrix(self):
        hashes = []
        for place in (libhair.Transform(translation=(0.25, 0, 0)),
                      [[1, 0, 0, 0.25], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
                      numpy.array([[1, 0, 0, 0.25], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])):
            simulation = small_simulation()
            simulation.step(world_from_head=place)
            hashes.append(simulation.state_hash())
        self.assertEqual(len(set(hashes)), 1)

    def test_settings_between_frames_matter_to_the_next(self):
        simulation = small_simulation()
        simulation.run(2)
        still = simulation.stats()["speed_max"]
        simulation.settings.wind.velocity = (8, 0, 0)
        simulation.run(5)
        self.assertGreater(simulation.stats()["speed_max"], still + 0.1)
        simulation.settings.lights = [LIGHT, libhair.Light.point((0, 2, 1))]
        simulation.light()
        self.assertEqual(simulation.transmittance.shape, (2, len(simulation.points)))
        self.assertLess(simulation.transmittance.min(), 0.5)
        simulation.settings.lights = []
        simulation.light()
        self.assertEqual(simulation.transmittance.shape[0], 0)

    def test_the_profile_has_the_stages(self):
        simulation = small_simulation()
        simulation.step()
        profile = simulation.profile
        self.assertEqual(profile["wisps"][1], len(simulation.points))
        self.assertGreater(profile["guides"][0], 0)

    def test_radiance_is_kept_where_it_is_asked_for(self):
        simulation = small_simulation()
        simulation.light()
        colours = simulation.colours.copy()
        self.assertEqual(simulation.radiance.shape, (0, 3))
        simulation.settings.radiance = True
        simulation.light()
        radiance = simulation.radiance
        self.assertEqual((radiance.shape, radiance.dtype), (simulation.points.shape, numpy.float32))
        numpy.testing.assert_array_equal(simulation.colours, colours)
        numpy.testing.assert_array_equal(libhair.encode_srgb(radiance), colours)
        simulation.settings.encode = False
        simulation.light()
        self.assertEqual(len(simulation.colours), 0)
        simulation.settings.appearance.ambient = 1e3
        simulation.light()
        self.assertGreater(simulation.radiance.min(), 1)

    def test_its_inside_can_be_drawn(self):
        simulation = small_simulation()
        simulation.run(5, motion=libhair.Motion.dance())
        for inside in ("guides", "tension", "guide frames", "contacts", "push", "colliders", "bricks"):
            ends, colours = simulation.lines(inside)
            self.assertEqual(ends.shape[1:], (3,), inside)
            self.assertEqual(colours.shape, (len(ends), 4), inside)
            self.assertEqual(len(ends) % 2, 0, inside)
        guides = simulation.guide_points()
        ends, _ = simulation.lines("guides")
        numpy.testing.assert_array_equal(ends[0], guides[0, 0])
        numpy.testing.assert_array_equal(ends[1], guides[0, 1])
        with self.assertRaisesRegex(libhair.Error, "there are guides, tension"):
            simulation.lines("hats")

    def test_visibility_darkens(self):
        simulation = small_simulation()
        simulation.light()
        lit = simulation.colours.astype(int).sum()
        self.assertIsNone(simulation.visibility)
        simulation.visibility = numpy.zeros((1, len(simulation.points)), numpy.float32)
        simulation.light()
        self.assertLess(simulation.colours.astype(int).sum(), lit)
        with self.assertRaisesRegex(ValueError, "visibility: shape"):
            simulation.visibility = numpy.zeros((1, 3), numpy.float32)


class Colliders(unittest.TestCase):
    def guide_points_after(self, **colliders):
        simulation = small_simulation()
        simulation.change_colliders(**colliders)
        simulation.run(30)
        return simulation.guide_points().reshape(-1, 3)

    def test_a_plane_holds_hair_up(self):
        free = self.guide_points_after()
        held = self.guide_points_after(planes=[[0, -0.1, 0, 0, 1, 0]])
        self.assertLess(free[:, 1].min(), -0.12)
        self.assertGreater(held[:, 1].min(), -0.105)

    def test_a_capsule_keeps_hair_out(self):
        a, b, radius = numpy.array([-0.3, -0.1, -0.1]), numpy.array([0.3, -0.1, -0.1]), 0.06
        points = self.guide_points_after(capsules=[[*a, *b, radius]])
        away = numpy.linalg.norm(points[:, 1:] - a[1:], axis=1)
        self.assertGreater(away.min(), radius - 2e-3)

    def test_a_mesh_keeps_hair_out_and_is_kept(self):
        ball = libhair.DistanceField(icosphere(0.06))
        mesh = libhair.MeshCollider(ball, libhair.Transform(translation=(0, -0.1, -0.1)))
        del ball
        points = self.guide_points_after(meshes=[mesh])
        away = numpy.linalg.norm(points - [0, -0.1, -0.1], axis=1)
        self.assertGreater(away.min(), 0.055)

    def test_colliders_that_cannot_be_are_refused(self):
        simulation = small_simulation()
        for message, colliders in [
            (r"capsules: shape \(1, 6\), but \(N, 7\)", {"capsules": [[0] * 6]}),
            ("planes: shape", {"planes": [1, 2, 3]}),
            ("not finite|finite", {"capsules": [[numpy.nan] * 7]}),
        ]:
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                simulation.step(**colliders)
        with self.assertRaises(TypeError):
            simulation.step(meshes=[3])
        simulation.step()


def icosphere(radius, rings=16):
    """A ball as a Mesh."""
    theta = numpy.linspace(0, numpy.pi, rings + 1)
    phi = numpy.arange(2 * rings) * numpy.pi / rings
    points = [(numpy.sin(t) * numpy.cos(p), numpy.cos(t), numpy.sin(t) * numpy.sin(p))
              for t in theta for p in phi]
    n = 2 * rings
    quads = [(i * n + j, i * n + (j + 1) % n, (i + 1) * n + (j + 1) % n, (i + 1) * n + j)
             for i in range(rings) for j in range(n)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return libhair.Mesh(numpy.array(points, numpy.float32) * numpy.float32(radius),
                        numpy.array(triangles, numpy.uint32))


if __name__ == "__main__":
    unittest.main()
