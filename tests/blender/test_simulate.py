"""Hair along the scene's frames."""

import unittest

import bpy
import numpy

from scene_for_tests import *


class MovingHead(unittest.TestCase):
    """One head turns by a right angle in half a second and stands still for the rest."""

    @classmethod
    def setUpClass(cls):
        cls.folder = folder()
        cls.scene = empty_scene(96)
        cls.head = sphere()
        turn(cls.head, 90, 13, 25)
        cls.hair = hair_on(cls.head)
        cls.hair.libhair.cache_folder = cls.folder.name
        cls.rest = local_points(cls.hair)
        cls.answer = bpy.ops.libhair.simulate()
        cls.frames = {}
        for frame in range(1, 97):
            cls.scene.frame_set(frame)
            cls.frames[frame] = world_points(cls.hair)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def in_head(self, frame):
        """(S, P, 3) in the head's space."""
        from libhair_blender import axes

        self.scene.frame_set(frame)
        back = numpy.linalg.inv(numpy.array(self.head.matrix_world, float))
        return axes.move(back, self.frames[frame]).reshape(-1, 12, 3)

    def test_it_finishes_where_it_began(self):
        self.assertEqual(self.answer, {"FINISHED"})
        bpy.context.scene.frame_set(1)
        self.assertTrue(has_file(self.hair.libhair.cache_path))

    def test_roots_follow_the_head(self):
        rest = self.rest.reshape(-1, 12, 3)[:, 0]
        for frame in self.frames:
            off = numpy.abs(self.in_head(frame)[:, 0] - rest).max()
            self.assertLess(off, 1e-5, f"frame {frame}")
        far = numpy.linalg.norm(self.frames[96] - self.frames[1], axis=1)
        self.assertGreater(far[::12].max(), 0.1, "the head turns")

    def test_tips_lag_behind_and_come_to_rest(self):
        before = self.in_head(12)[:, -1]
        late = self.in_head(19)[:, -1] - before
        # What a turn to the left leaves behind is to the right: against the way of a rigid tip.
        ahead = numpy.cross([0, 0, 1], before)
        against = -(late * ahead).sum(axis=1) / numpy.linalg.norm(ahead, axis=1)
        self.assertGreater(numpy.median(against), 0.01)
        speed = [
            numpy.linalg.norm(self.frames[f + 1] - self.frames[f], axis=1).max() for f in (19, 95)
        ]
        self.assertGreater(speed[0], 5e-3)
        self.assertLess(speed[1], 1e-3)

    def test_no_point_is_inside_the_head(self):
        for frame, points in self.frames.items():
            away = numpy.linalg.norm(points - CENTRE, axis=1).reshape(-1, 12)[:, 1:]
            self.assertGreater(away.min(), RADIUS - 1e-3, f"frame {frame}")

    def test_scrubbing_gives_the_same_points_as_playing(self):
        for frame in (50, 3, 96, 18, 3):
            self.scene.frame_set(frame)
            self.assertEqual(world_points(self.hair).tobytes(), self.frames[frame].tobytes())

    def test_between_two_frames_hair_is_between_them(self):
        from libhair_blender import cache

        frames = cache.reader(bpy.path.abspath(self.hair.libhair.cache_path))
        self.scene.frame_set(18, subframe=0.25)
        shown = local_points(self.hair)
        self.assertLess(
            numpy.abs(shown - (0.75 * frames.points(18) + 0.25 * frames.points(19))).max(), 1e-7
        )

    def test_before_and_after_the_frames_hair_is_as_at_their_ends(self):
        self.scene.frame_set(1)
        first = local_points(self.hair).tobytes()
        self.scene.frame_set(96)
        last = local_points(self.hair).tobytes()
        self.assertNotEqual(first, last)
        self.scene.frame_set(-5)
        self.assertEqual(local_points(self.hair).tobytes(), first)
        self.scene.frame_set(200)
        self.assertEqual(local_points(self.hair).tobytes(), last)


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = folder()
        self.scene = empty_scene(12)
        self.head = sphere()
        turn(self.head, 60, 1, 8)
        self.hair = hair_on(self.head)
        self.hair.libhair.cache_folder = self.folder.name

    def tearDown(self):
        self.folder.cleanup()

    def simulate(self, hair=None):
        select(hair or self.hair)
        self.assertEqual(bpy.ops.libhair.simulate(), {"FINISHED"})
        hair = bpy.context.object
        with open(bpy.path.abspath(hair.libhair.cache_path), "rb") as file:
            return file.read()

    def test_two_runs_have_the_same_bits(self):
        self.assertEqual(self.simulate(), self.simulate())

    def test_a_run_from_the_middle_of_playback_is_the_same_run(self):
        first = self.simulate()
        self.scene.frame_set(9, subframe=0.5)
        self.assertEqual(self.simulate(), first)
        self.assertEqual(self.scene.frame_current_final, 9.5)

    def test_free_cache_gives_the_object_back_to_the_bit(self):
        names = {a.name for a in self.hair.data.attributes}
        before = local_points(self.hair).tobytes()
        self.simulate()
        path = bpy.path.abspath(self.hair.libhair.cache_path)
        self.scene.frame_set(7)
        self.assertNotEqual(local_points(self.hair).tobytes(), before)
        self.assertEqual(bpy.ops.libhair.free_cache(), {"FINISHED"})
        self.assertEqual(local_points(self.hair).tobytes(), before)
        self.assertEqual({a.name for a in self.hair.data.attributes}, names)
        self.assertFalse(has_file(path))
        self.scene.frame_set(3)
        self.assertEqual(local_points(self.hair).tobytes(), before)
        self.assertFalse(bpy.ops.libhair.free_cache.poll())

    def test_a_saved_file_opens_with_its_frames(self):
        path = self.folder.name + "/scene.blend"
        bpy.ops.wm.save_as_mainfile(filepath=path)
        self.hair.libhair.cache_folder = ""
        self.simulate()
        self.assertTrue(self.hair.libhair.cache_path.startswith("//libhair_cache"))
        self.scene.frame_set(6)
        then = local_points(self.hair).tobytes()
        self.scene.frame_set(1)
        bpy.ops.wm.save_mainfile()
        bpy.ops.wm.open_mainfile(filepath=path)
        bpy.context.scene.frame_set(6)
        self.assertEqual(local_points(bpy.data.objects["hair"]).tobytes(), then)

    def test_a_scene_in_centimetres_moves_as_one_in_metres(self):
        self.simulate()
        self.scene.frame_set(8)
        metres = world_points(self.hair)
        empty_scene(12)
        bpy.context.scene.unit_settings.scale_length = 0.01
        head = sphere(centre=100 * CENTRE, radius=100 * RADIUS)
        turn(head, 60, 1, 8)
        hair = hair_on(head, 100 * lock())
        hair.libhair.cache_folder = self.folder.name
        hair.libhair.detail = 0.4
        self.simulate(hair)
        bpy.context.scene.frame_set(8)
        # The same up to rounding, which a swing of twelve frames makes larger.
        self.assertLess(numpy.abs(world_points(hair) / 100 - metres).max(), 1e-3)

    def test_a_head_of_another_scale_carries_the_same_hair(self):
        self.simulate()
        self.scene.frame_set(8)
        plain = world_points(self.hair)
        select(self.hair)
        bpy.ops.libhair.free_cache()
        self.scene.frame_set(1)
        self.head.scale = (0.5, 0.5, 0.5)
        self.head.data.transform(((2, 0, 0, 0), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 1)))
        self.hair.scale = (2, 2, 2)
        bpy.context.view_layer.update()
        self.simulate()
        self.scene.frame_set(8)
        self.assertLess(numpy.abs(world_points(self.hair) - plain).max(), 1e-3)

    def test_wind_blows_where_it_says(self):
        self.head.animation_data_clear()
        self.simulate()
        self.scene.frame_set(12)
        calm = world_points(self.hair)
        self.hair.libhair.wind = (0, 2, 0)
        self.simulate()
        blown = (world_points(self.hair) - calm).reshape(-1, 12, 3)[:, -1].mean(axis=0)
        self.assertGreater(blown[1], 0.01)
        self.assertLess(abs(blown[0]), 0.3 * blown[1])
        self.assertLess(abs(blown[2]), 0.6 * blown[1], "no more than hair rises that swings")

    def test_a_mesh_of_the_collection_keeps_hair_out(self):
        group = bpy.data.collections.new("colliders")
        ball = sphere("ball", CENTRE + [0.5, 0, -0.1], 0.06)
        group.objects.link(ball)
        ball.keyframe_insert("location", frame=1)
        ball.location = CENTRE + [0.17, 0, -0.1]
        ball.keyframe_insert("location", frame=10)
        inside = []
        for colliders in (None, group):
            self.hair.libhair.colliders = colliders
            self.simulate()
            self.scene.frame_set(12)
            away = numpy.linalg.norm(world_points(self.hair) - numpy.array(ball.location), axis=1)
            inside.append(0.06 - away.min())
        self.assertGreater(inside[0], 5e-3, "without it hair is inside")
        self.assertLess(inside[1], 1e-3)

    def test_wind_does_not_blow_hair_into_the_head(self):
        self.hair.libhair.wind = (0, 8, 0)
        inside = []
        for self.hair.libhair.collide_head in (False, True):
            self.simulate()
            self.scene.frame_set(12)
            away = numpy.linalg.norm(world_points(self.hair) - CENTRE, axis=1).reshape(-1, 12)
            inside.append(RADIUS - away[:, 1:].min())
        self.assertGreater(inside[0], 5e-3, "without it hair is inside")
        self.assertLess(inside[1], 1e-3)

    def test_bones_carry_hair_and_keep_it_out(self):
        data = bpy.data.armatures.new("rig")
        rig = bpy.data.objects.new("rig", data)
        bpy.context.collection.objects.link(rig)
        select(rig)
        bpy.ops.object.mode_set(mode="EDIT")
        for name, head, tail, radius in (
            ("skull", CENTRE, CENTRE + [0, 0, 0.1], 0.5),
            ("arm", CENTRE + [0.14, 0, -0.3], CENTRE + [0.14, 0, 0.1], 0.04),
        ):
            bone = data.edit_bones.new(name)
            bone.head, bone.tail = head, tail
            bone.head_radius = bone.tail_radius = radius
        bpy.ops.object.mode_set(mode="OBJECT")
        skull = rig.pose.bones["skull"]
        skull.rotation_mode = "XYZ"
        skull.keyframe_insert("rotation_euler", frame=1)
        skull.rotation_euler.y = numpy.pi / 3
        skull.keyframe_insert("rotation_euler", frame=8)
        self.hair.parent = None
        self.hair.location = CENTRE
        ours = self.hair.libhair
        ours.head, ours.bone, ours.body = rig, "skull", rig
        self.scene.frame_set(1)
        roots = world_points(self.hair).reshape(-1, 12, 3)[:, 0]
        self.simulate()
        self.scene.frame_set(12)
        shown = world_points(self.hair).reshape(-1, 12, 3)
        # The bone stands upright, so its turn about Y is one about the world's vertical.
        c, s = numpy.cos(numpy.pi / 3), numpy.sin(numpy.pi / 3)
        turned = (roots - CENTRE) @ numpy.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + CENTRE
        self.assertLess(numpy.abs(shown[:, 0] - turned).max(), 1e-5)
        arm = numpy.linalg.norm((shown[:, 1:] - CENTRE - [0.14, 0, 0])[..., :2], axis=-1)
        self.assertGreater(arm.min(), 0.04 - 1e-3)

    def test_poly_curves_and_edges_become_curves_and_come_back(self):
        points = lock(20)
        plain = self.rest_of_plain(points)
        edges = [(i, i + 1) for i in range(len(points) * 12 - 1) if (i + 1) % 12]
        mesh = bpy.data.meshes.new("edges")
        mesh.from_pydata(points.reshape(-1, 3).tolist(), edges, [])
        data = bpy.data.curves.new("poly", "CURVE")
        data.dimensions = "3D"
        for strand in points:
            spline = data.splines.new("POLY")
            spline.points.add(11)
            spline.points.foreach_set("co", numpy.pad(strand, ((0, 0), (0, 1))).reshape(-1))
        for source_data in (mesh, data):
            source = bpy.data.objects.new("strands", source_data)
            bpy.context.collection.objects.link(source)
            source.parent = self.head
            source.libhair.cache_folder = self.folder.name
            frames = self.simulate(source)
            self.assertEqual(frames, plain)
            copy = bpy.context.object
            self.assertEqual((copy.type, source.hide_render), ("CURVES", True))
            bpy.ops.libhair.free_cache()
            self.assertEqual(bpy.context.object, source)
            self.assertFalse(source.hide_viewport or source.hide_render)
            self.assertNotIn("strands.libhair", bpy.data.objects)
            bpy.data.objects.remove(source)

    def rest_of_plain(self, points):
        hair = hair_on(self.head, points, "plain")
        hair.libhair.cache_folder = self.folder.name
        return self.simulate(hair)


run(MovingHead, Runs)
