"""What cannot be done is said in words, and leaves everything as it was."""

import os
import unittest

import bpy

from scene_for_tests import *


class Errors(unittest.TestCase, Refusals):
    def setUp(self):
        self.folder = folder()
        self.scene = empty_scene(6)
        self.head = sphere()
        self.hair = hair_on(self.head, lock(30))
        self.hair.libhair.cache_folder = self.folder.name
        self.points = local_points(self.hair).tobytes()
        self.scene.frame_set(3)

    def tearDown(self):
        # Whatever was refused: the hair, the frame and the folder are as before.
        self.assertEqual(local_points(self.hair).tobytes(), self.points)
        self.assertEqual(self.hair.libhair.cache_path, "")
        self.assertEqual(self.scene.frame_current, 3)
        self.assertEqual(os.listdir(self.folder.name), [])
        self.assertNotIn("libhair_rest", self.hair.data.attributes)
        self.folder.cleanup()

    def refused(self, words, obj=None):
        select(obj or self.hair)
        self.assert_refused(words, bpy.ops.libhair.simulate)

    def test_an_empty_is_no_hair(self):
        empty = bpy.data.objects.new("nothing", None)
        bpy.context.collection.objects.link(empty)
        select(empty)
        self.assertFalse(bpy.ops.libhair.simulate.poll())
        self.assertFalse(bpy.ops.libhair.shadow.poll())

    def test_a_mesh_with_faces_is_no_hair(self):
        self.refused("'head' is a mesh with faces, not hair", self.head)

    def test_bezier_curves_say_how_to_become_poly_curves(self):
        bpy.ops.curve.primitive_bezier_curve_add()
        self.refused("BEZIER splines: set their type to Poly", bpy.context.object)

    def test_branches_and_rings_of_edges_are_no_strands(self):
        for edges, words in (
            ([(0, 1), (0, 2), (0, 3)], "3 edges meet at vertex 0"),
            ([(0, 1), (1, 2), (2, 0)], "a ring of edges"),
        ):
            mesh = bpy.data.meshes.new("edges")
            mesh.from_pydata([(i, 0, 0) for i in range(4)], edges, [])
            obj = bpy.data.objects.new("edges", mesh)
            bpy.context.collection.objects.link(obj)
            self.refused(words, obj)

    def test_hair_on_nothing_asks_for_a_head(self):
        self.hair.parent = None
        self.refused("is on no head: choose one")

    def test_an_armature_as_head_asks_for_a_bone(self):
        bpy.ops.object.armature_add()
        self.hair.libhair.head = bpy.context.object
        self.refused("choose the bone that carries the hair")
        self.hair.libhair.bone = "Nose"
        self.refused("has no bone 'Nose'")

    def test_a_flat_mesh_has_no_inside(self):
        bpy.ops.mesh.primitive_plane_add()
        self.hair.libhair.head = bpy.context.object
        self.refused("is flat: what keeps hair out must have an inside")

    def test_a_mesh_without_faces_collides_with_nothing(self):
        mesh = bpy.data.meshes.new("dots")
        mesh.from_pydata([(0, 0, 0), (0, 0, 1), (0, 1, 0)], [], [])
        dots = bpy.data.objects.new("dots", mesh)
        bpy.context.collection.objects.link(dots)
        self.hair.libhair.head = dots
        self.refused("'dots' has no faces")

    def test_a_head_that_grows_is_refused(self):
        self.head.keyframe_insert("scale", frame=2)
        self.head.scale = (1.2, 1.2, 1.2)
        self.head.keyframe_insert("scale", frame=5)
        self.refused("'head' changes its size at frame 3")
        self.scene.frame_set(3)

    def test_a_collider_that_changes_its_shape_is_refused_where_it_does(self):
        ball = sphere("ball", CENTRE + [1, 0, 0])
        ball.shape_key_add(name="Basis")
        key = ball.shape_key_add(name="wide")
        key.data[0].co.z += 0.05
        key.value = 0
        key.keyframe_insert("value", frame=3)
        key.value = 1
        key.keyframe_insert("value", frame=5)
        group = bpy.data.collections.new("colliders")
        group.objects.link(ball)
        self.hair.libhair.colliders = group
        self.refused("'ball' changes its shape at frame 4: .* capsules of an armature")

    def test_strands_without_length_are_the_librarys_refusal(self):
        points = lock(5)
        points[2] = points[2, 0]
        self.refused("drop degenerate strands", hair_on(self.head, points, "dots"))

    def test_a_folder_that_is_a_file_is_refused(self):
        with folder() as other:
            path = os.path.join(other, "taken")
            open(path, "w").close()
            self.hair.libhair.cache_folder = path
            self.refused("cannot be written .*; choose another cache folder")

    def test_a_shadow_without_lights_asks_for_one(self):
        select(self.hair)
        self.assert_refused("add a sun, a point or a spot", bpy.ops.libhair.shadow)
        self.assertNotIn("shadow", self.hair.data.attributes)

    def test_a_shadow_on_a_poly_curve_says_to_convert(self):
        bpy.ops.object.light_add(type="SUN")
        data = bpy.data.curves.new("poly", "CURVE")
        poly = bpy.data.objects.new("poly", data)
        bpy.context.collection.objects.link(poly)
        select(poly)
        self.assert_refused("convert it to Curves", bpy.ops.libhair.shadow)

    def test_files_that_are_no_hair_mesh_are_the_librarys_refusal(self):
        with folder() as other:
            path = os.path.join(other, "broken.obj")
            with open(path, "w") as file:
                file.write("v 0 0 zero\n")
            self.assert_refused("broken.obj", bpy.ops.libhair.open_hair_mesh, filepath=path)
            self.assert_refused(
                "missing", bpy.ops.libhair.open_hair_mesh, filepath=path + ".missing"
            )

    def test_one_layer_is_no_hair_mesh(self):
        select(self.head)
        self.assert_refused("two layers or more", bpy.ops.libhair.grow)


class Caches(unittest.TestCase):
    """A cache that is gone, cut or of other hair: the hair stays, and the panel says why."""

    def setUp(self):
        self.folder = folder()
        self.scene = empty_scene(6)
        self.hair = hair_on(sphere(), lock(30))
        self.ours = self.hair.libhair
        self.ours.cache_folder = self.folder.name
        bpy.ops.libhair.simulate()
        self.path = self.ours.cache_path

    def tearDown(self):
        self.folder.cleanup()

    def message_at(self, frame):
        before = local_points(self.hair).tobytes()
        self.scene.frame_set(frame)
        if self.ours.message:
            self.assertEqual(local_points(self.hair).tobytes(), before)
        return self.ours.message

    def test_damage_is_said_and_forgotten_when_it_is_repaired(self):
        self.assertEqual(self.message_at(2), "")
        whole = open(self.path, "rb").read()
        for damage, words in (
            (lambda: os.remove(self.path), "simulate again, or free the cache"),
            (lambda: self.rewrite(whole[:-1]), "not all of one"),
            (lambda: self.rewrite(whole[:100]), "not all of one"),
            (lambda: self.rewrite(b"?" + whole[1:]), "no cache of hair"),
        ):
            damage()
            self.assertIn(words, self.message_at(4))
        self.rewrite(whole)
        self.assertEqual(self.message_at(3), "")

    def rewrite(self, content):
        with open(self.path + ".new", "wb") as file:
            file.write(content)
        os.replace(self.path + ".new", self.path)

    def test_frames_of_other_hair_are_not_shown(self):
        other = hair_on(None, lock(31), "other")
        other.libhair.cache_path = self.path
        self.scene.frame_set(5)
        self.assertIn("372 points, its cache 360", other.libhair.message)


run(Errors, Caches)
