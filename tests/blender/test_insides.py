"""The inside of a simulation as an object of coloured tubes."""

import os
import unittest

import bpy
import numpy

from scene_for_tests import *

YELLOW = (1, 0.694, 0.033)  # of guides, linear


class Insides(unittest.TestCase, Refusals):
    def setUp(self):
        self.folder = folder()
        self.scene = empty_scene(8)
        self.head = sphere()
        turn(self.head, 60, 1, 8)
        self.hair = hair_on(self.head)
        self.ours = self.hair.libhair
        self.ours.cache_folder = self.folder.name
        self.ours.guides = 20

    def tearDown(self):
        self.folder.cleanup()

    def simulate(self, *insides):
        self.ours.insides = set(insides)
        select(self.hair)
        self.assertEqual(bpy.ops.libhair.simulate(), {"FINISHED"})
        with open(bpy.path.abspath(self.ours.cache_path), "rb") as file:
            return file.read()

    def tubes(self):
        """Of each line both ends (n, 2, 3), float64, and its colours (n, 2, 4)."""
        data = self.ours.insides_object.data
        self.assertEqual(len(data.polygons) % 3, 0)
        corners = numpy.empty((len(data.vertices), 3), numpy.float32)
        data.vertices.foreach_get("co", corners.reshape(-1))
        colours = numpy.empty((len(corners), 4), numpy.float32)
        if len(corners):
            data.attributes["inside"].data.foreach_get("color", colours.reshape(-1))
            self.assertEqual(data.color_attributes.active_color.name, "inside")
        corners = corners.reshape(-1, 2, 3, 3)
        middle = corners.mean(axis=2)
        away = numpy.linalg.norm(corners - middle[:, :, None], axis=-1)
        self.assertTrue((numpy.abs(away / self.ours.insides_width - 0.5) < 0.05).all())
        return middle.astype(float), colours.reshape(-1, 2, 3, 4)[:, :, 0]

    def test_guides_are_on_the_head_and_follow_the_frames(self):
        self.simulate("GUIDES")
        self.assertTrue(self.ours.insides_object.users_collection)
        roots = {}
        for frame in (1, 8, 1):
            self.scene.frame_set(frame)
            ends, colours = self.tubes()
            self.assertEqual(len(ends), 20 * (self.ours.points_per_guide - 1))
            self.assertLess(numpy.abs(colours[..., :3] - YELLOW).max(), 2e-3)
            links = ends.reshape(20, -1, 2, 3)
            self.assertLess(numpy.abs(links[:, 1:, 0] - links[:, :-1, 1]).max(), 1e-5, "chains")
            # Each guide begins where a strand does.
            strands = world_points(self.hair).reshape(-1, 12, 3)[:, 0]
            off = numpy.linalg.norm(links[:, 0, 0, None] - strands, axis=-1).min(axis=1)
            self.assertLess(off.max(), 1e-5)
            same = roots.setdefault(frame, links)
            self.assertTrue((same == links).all())
        self.assertGreater(numpy.abs(roots[8][:, 0, 0] - roots[1][:, 0, 0]).max(), 0.03)

    def test_they_do_not_move_the_hair(self):
        bpy.ops.object.light_add(type="SUN")
        plain = self.simulate()
        self.assertIsNone(self.ours.insides_object)
        every = [item.identifier for item in self.ours.bl_rna.properties["insides"].enum_items]
        self.assertEqual(len(every), 7)
        self.assertEqual(self.simulate(*every), plain)
        for one in every:
            self.ours.insides = {one}
            # Nothing may touch, and so few strands may not be crowded.
            self.assertTrue(one in {"CONTACTS", "PUSH"} or len(self.tubes()[0]), one)

    def test_colliders_are_where_the_head_is(self):
        self.simulate("COLLIDERS")
        self.scene.frame_set(5)
        ends, _ = self.tubes()
        away = numpy.linalg.norm(ends - CENTRE, axis=-1)
        self.assertGreater(len(ends), 500)
        self.assertLess(numpy.abs(away - RADIUS).max(), 3e-3)

    def test_bricks_are_about_the_hair_and_want_a_light(self):
        self.ours.insides = {"BRICKS"}
        select(self.hair)
        self.assert_refused("add a sun, a point or a spot", bpy.ops.libhair.simulate)
        self.assertEqual(os.listdir(self.folder.name), [])
        bpy.ops.object.light_add(type="SUN")
        self.simulate("BRICKS")
        self.scene.frame_set(4)
        ends, _ = self.tubes()
        hair, ends = world_points(self.hair), ends.reshape(-1, 3)
        self.assertTrue((ends.min(axis=0) < hair.min(axis=0)).all())
        self.assertTrue((ends.max(axis=0) > hair.max(axis=0)).all())
        self.assertLess(numpy.ptp(ends, axis=0).max(), numpy.ptp(hair, axis=0).max() + 0.2)

    def test_switches_show_what_was_kept(self):
        from libhair_blender import insides

        self.simulate("GUIDES", "TENSION")
        both = len(self.tubes()[0])
        self.ours.insides = {"TENSION"}
        ends, colours = self.tubes()
        self.assertEqual(2 * len(ends), both)
        self.assertGreater(numpy.ptp(colours[..., 0]), 0.1, "not all are pulled alike")
        self.ours.insides = {"TENSION", "PUSH"}
        self.assertEqual(insides.missing(self.hair), ["push"])
        self.assertEqual(2 * len(self.tubes()[0]), both)
        self.ours.insides_width *= 3
        self.tubes()
        name = self.ours.insides_object.name
        self.ours.insides = set()
        self.assertIsNone(self.ours.insides_object)
        self.assertNotIn(name, bpy.data.objects)
        self.assertNotIn(name, bpy.data.meshes)
        self.scene.frame_set(3)

    def test_free_cache_leaves_nothing(self):
        before = local_points(self.hair).tobytes()
        self.simulate("GUIDES")
        self.assertEqual(len(os.listdir(self.folder.name)), 2)
        select(self.hair)
        bpy.ops.libhair.free_cache()
        self.assertIsNone(self.ours.insides_object)
        self.assertNotIn("hair.insides", bpy.data.objects)
        self.assertEqual(os.listdir(self.folder.name), [])
        self.assertEqual(local_points(self.hair).tobytes(), before)
        self.simulate("GUIDES")
        self.simulate()
        self.assertEqual(len(os.listdir(self.folder.name)), 1, "lines of the run before")

    def test_a_file_that_is_cut_is_said(self):
        self.simulate("GUIDES")
        path = bpy.path.abspath(self.ours.cache_path) + ".lines"
        whole = open(path, "rb").read()
        for damage in (whole[:-8], whole[:100], b"?" + whole[1:]):
            with open(path + ".new", "wb") as file:
                file.write(damage)
            os.replace(path + ".new", path)
            self.scene.frame_set(self.scene.frame_current % 7 + 1)
            self.assertIn("no cache of hair, or not all of one", self.ours.message)

    def test_a_scene_in_centimetres_shows_them_at_its_scale(self):
        self.scene = empty_scene(2)
        self.scene.unit_settings.scale_length = 0.01
        head = sphere(centre=100 * CENTRE, radius=100 * RADIUS)
        self.hair = hair_on(head, 100 * lock())
        self.ours = self.hair.libhair
        self.ours.cache_folder, self.ours.detail = self.folder.name, 0.4
        self.ours.insides_width = 0.05
        self.simulate("COLLIDERS")
        away = numpy.linalg.norm(self.tubes()[0] - 100 * CENTRE, axis=-1)
        self.assertLess(numpy.abs(away - 100 * RADIUS).max(), 0.3)


run(Insides)
