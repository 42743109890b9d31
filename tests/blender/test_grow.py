"""Hair meshes become curves."""

import os
import unittest

import bpy
import numpy

from scene_for_tests import *


def boxes(layers=4, side=0.1, height=0.05):
    """Meshes layer_0 ... of 2 x 2 quads, one above the other along +Z, from the origin."""
    objects = []
    for k in range(layers):
        places = [(x * side / 2, y * side / 2, 0) for y in range(3) for x in range(3)]
        faces = [(i, i + 1, i + 4, i + 3) for i in (0, 1, 3, 4)]
        mesh = bpy.data.meshes.new(f"layer_{k}")
        mesh.from_pydata(places, [], faces)
        obj = bpy.data.objects.new(f"layer_{k}", mesh)
        obj.location.z = height * k
        bpy.context.collection.objects.link(obj)
        objects.append(obj)
    bpy.context.view_layer.update()
    return objects


def select_all(objects):
    for obj in bpy.context.selected_objects:
        obj.select_set(False)
    for obj in objects:
        obj.select_set(True)


class Grow(unittest.TestCase, Refusals):
    def setUp(self):
        self.scene = empty_scene()

    def test_a_script_grows_the_strands_it_says(self):
        import libhair
        from libhair_blender import axes

        path = str(MODELS / "bob.hairmesh")
        self.assertEqual(bpy.ops.libhair.open_hair_mesh(filepath=path, points=12), {"FINISHED"})
        hair = bpy.context.object
        groom = libhair.hair_mesh_groom(path, points=12)
        self.assertEqual((hair.type, hair.name), ("CURVES", "bob"))
        self.assertEqual(len(hair.data.curves), groom.strand_count)
        self.assertEqual(len(hair.data.points), groom.point_count)
        points = local_points(hair).reshape(-1, 12, 3)
        lengths = numpy.linalg.norm(numpy.diff(points, axis=1), axis=2).sum(axis=1)
        drawn = libhair.Simulation(groom, libhair.FrameSettings(lights=(), shadow=False, shade=False))
        self.assertLess(numpy.abs(lengths - drawn.strands.lengths()).max(), 1e-5)
        # A bob hangs beside the face: it ends below its roots in Blender's Z, and grows on the
        # built-in head, whose face looks to -Y.
        roots = points[:, 0]
        self.assertLess((points[:, -1, 2] - roots[:, 2]).mean(), -0.05)
        head = axes.from_libhair(libhair.builtin_head().positions)
        far = [numpy.linalg.norm(head - root, axis=1).min() for root in roots[::200]]
        self.assertLess(max(far), 0.02)

    def test_radius_is_half_the_width_of_a_hair(self):
        from libhair_blender import curves

        path = str(MODELS / "short.hairmesh")
        bpy.ops.libhair.open_hair_mesh(filepath=path, strands=50, points=8, hairs=5000)
        hair = bpy.context.object
        radius = curves.get(hair.data, "radius", "value", len(hair.data.points))
        self.assertLess(numpy.abs(radius - hair.libhair.width / 2).max(), 1e-9)
        self.assertEqual(hair.libhair.hairs, 5000)

    def test_layers_of_the_scene_grow_straight_up_their_prism(self):
        select_all(boxes())
        self.assertEqual(bpy.ops.libhair.grow(strands=300, points=9), {"FINISHED"})
        hair = bpy.context.object
        points = local_points(hair).reshape(300, 9, 3)
        self.assertLess(numpy.abs(points[:, 0, 2]).max(), 1e-6)
        self.assertLess(numpy.abs(points[:, -1, 2] - 0.15).max(), 1e-5)
        self.assertLess(numpy.abs(points[:, :, :2] - points[:, :1, :2]).max(), 1e-5)
        self.assertGreater(points[..., :2].min(), -1e-6)
        self.assertLess(points[..., :2].max(), 0.1 + 1e-6)
        # All four faces have hair.
        quadrant = (points[:, 0, :2] > 0.05) @ [1, 2]
        self.assertGreater(numpy.bincount(quadrant, minlength=4).min(), 40)

    def test_layers_go_by_their_numbers_not_by_their_names(self):
        layers = boxes(12, height=0.01)
        select_all(layers)
        bpy.ops.libhair.grow(strands=50, points=30)
        rising = numpy.diff(local_points(bpy.context.object).reshape(50, 30, 3)[..., 2], axis=1)
        self.assertGreater(rising.min(), 0, "layer_10 is above layer_9, not above layer_1")

    def test_layers_that_disagree_are_refused_by_name(self):
        layers = boxes()
        layers[2].data.clear_geometry()
        layers[2].data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
        select_all(layers)
        self.assert_refused("layer_0, layer_1, layer_2, layer_3", bpy.ops.libhair.grow)

    def test_particle_hair_becomes_curves_with_its_roots_on_the_skin(self):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=0.1, segments=64, ring_count=32)
        skin = bpy.context.object
        modifier = skin.modifiers.new("hair", "PARTICLE_SYSTEM")
        particles = skin.particle_systems[0].settings
        particles.type, particles.count, particles.hair_length = "HAIR", 80, 0.3
        bpy.context.view_layer.update()
        bpy.ops.object.modifier_convert(modifier=modifier.name)
        edges = bpy.context.object
        self.assertEqual(bpy.ops.libhair.to_curves(), {"FINISHED"})
        hair = bpy.context.object
        self.assertEqual((hair.type, len(hair.data.curves), edges.hide_render), ("CURVES", 80, True))
        away = numpy.linalg.norm(world_points(hair).reshape(80, -1, 3), axis=2)
        self.assertLess(numpy.abs(away[:, 0] - 0.1).max(), 1e-3)
        self.assertGreater(away[:, -1].min(), 0.15)

    def test_grown_hair_can_be_moved_at_once(self):
        with folder() as where:
            self.scene.frame_end = 3
            path = str(MODELS / "short.hairmesh")
            bpy.ops.libhair.open_hair_mesh(filepath=path, strands=100, points=8)
            hair = bpy.context.object
            bpy.ops.object.empty_add()
            hair.parent = bpy.context.object
            hair.libhair.cache_folder = where
            select(hair)
            self.assertEqual(bpy.ops.libhair.simulate(), {"FINISHED"})
            (file,) = os.listdir(where)
            self.assertRegex(file, r"^short\.[0-9a-f]{8}\.haircache$")


run(Grow)
