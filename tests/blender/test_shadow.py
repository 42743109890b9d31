"""Shadow as a colour attribute."""

import unittest

import bpy
import numpy

from scene_for_tests import *


def attribute(data, name="shadow"):
    from libhair_blender import curves

    return curves.get(data, name, "color", (len(data.attributes[name].data), 4))


def curtain(strands=4000, points=16):
    """(S, P, 3): a block of crimped hair that hangs down, 0.2 m each way from the origin; crimped,
    since hair that lies along the light casts no shadow."""
    random = numpy.random.default_rng(3)
    roots = random.uniform(0, 0.2, (strands, 1, 3)) * [1, 1, 0] + [0, 0, 0.2]
    crimp = numpy.where(numpy.arange(points) % 2, 0.006, 0)[None, :, None] * [1, 1, 0]
    down = numpy.linspace(0, 0.2, points)[None, :, None] * [0, 0, 1]
    return (roots + crimp - down).astype(numpy.float32)


def light(kind, location=(0, 0, 0), rotation=(0, 0, 0), energy=1.0, color=(1, 1, 1), name=None):
    bpy.ops.object.light_add(type=kind, location=location, rotation=rotation)
    obj = bpy.context.object
    obj.data.energy, obj.data.color = energy, color
    if name:
        obj.name = name
    return obj


class Shadow(unittest.TestCase):
    def setUp(self):
        self.scene = empty_scene(10)
        self.hair = hair_on(None, curtain())
        self.hair.location = (0.5, -1, 1)
        self.hair.libhair.hairs = 8000
        self.local = curtain().reshape(-1, 3)

    def shadow(self, obj=None):
        select(obj or self.hair)
        self.assertEqual(bpy.ops.libhair.shadow(), {"FINISHED"})
        return attribute(self.hair.data)

    def test_hair_is_lit_where_the_sun_stands_and_dark_behind(self):
        for rotation, depth in (
            ((0, 0, 0), 0.2 - self.local[:, 2]),  # shines down
            ((numpy.pi / 2, 0, 0), self.local[:, 1]),  # shines to +Y
            ((0, numpy.pi / 2, 0), 0.2 - self.local[:, 0]),  # shines to -X
        ):
            sun = light("SUN", rotation=rotation)
            shown = self.shadow()
            self.assertEqual(shown[:, 3].min(), 1)
            self.assertTrue((shown[:, 0] == shown[:, 1]).all())
            self.assertGreater(shown[depth < 0.004, 0].mean(), 0.95)
            self.assertLess(shown[depth > 0.18, 0].mean(), 0.4)
            bpy.data.objects.remove(sun)

    def test_it_is_what_libhair_says(self):
        import libhair
        from libhair_blender import axes

        light("SUN", rotation=(0.4, 0.3, 0))
        shown = self.shadow()
        way = numpy.array(bpy.context.scene.objects["Sun"].matrix_world)[:3, :3] @ [0, 0, -1]
        points = numpy.ascontiguousarray(axes.to_libhair(world_points(self.hair)), numpy.float32)
        first = numpy.arange(4001, dtype=numpy.uint32) * 16
        direct = libhair.shadow(
            libhair.Strands(points, first),
            libhair.Light.parallel((way[0], way[2], -way[1])),
            0.003,
            fibre=libhair.Fibre(hairs_per_strand=2),
        )
        self.assertLess(numpy.abs(shown[:, 0] - direct).max(), 1e-3)
        self.assertLess(direct.min(), 0.5)

    def test_a_lamp_shadows_what_is_behind_as_seen_from_it(self):
        lamp = light("POINT", location=(0.6, -1.5, 1.1), energy=10)
        front = self.shadow()[:, 0]
        lamp.location = (0.6, -0.3, 1.1)
        bpy.context.view_layer.update()
        back = self.shadow()[:, 0]
        near = self.local[:, 1] < 0.03
        self.assertGreater(front[near].mean() - back[near].mean(), 0.3)
        lamp.data.type = "SPOT"
        bpy.context.view_layer.update()
        self.assertEqual(self.shadow()[:, 0].tobytes(), back.tobytes())

    def test_of_several_lights_each_has_an_attribute_and_all_are_a_mean(self):
        light("SUN", name="red", color=(1, 0, 0), energy=2, rotation=(numpy.pi / 2, 0, 0))
        light("SUN", name="white", energy=2)
        shown = self.shadow()
        red, white = (attribute(self.hair.data, "shadow." + n)[:, 0] for n in ("red", "white"))
        self.assertLess(numpy.abs(shown[:, 0] - (red + white) / 2).max(), 1e-6)
        self.assertLess(numpy.abs(shown[:, 1] - white).max(), 1e-6)
        bpy.data.objects["red"].hide_render = True
        self.assertEqual(self.shadow()[:, 0].tobytes(), white.tobytes())
        names = [a.name for a in self.hair.data.attributes if a.name.startswith("shadow")]
        self.assertEqual(names, ["shadow"], "of a light that is off none is left")

    def test_more_and_wider_hair_is_darker(self):
        light("SUN", rotation=(numpy.pi / 2, 0, 0))
        usual = self.shadow()[:, 0].mean()
        ours = self.hair.libhair
        ours.hairs *= 2
        twice = self.shadow()[:, 0].mean()
        self.assertLess(twice, usual - 0.05)
        ours.hairs /= 2
        ours.width *= 2
        # Nearly: fewer, wider hairs leave a little less (Extinction::Unbiased).
        self.assertLess(abs(self.shadow()[:, 0].mean() - twice), 5e-3)
        ours.width_from_radius = True
        self.assertLess(abs(self.shadow()[:, 0].mean() - usual), 1e-4, "radius 40 um: width 80 um")

    def test_it_follows_the_frames_when_told_to(self):
        sun = light("SUN", rotation=(numpy.pi / 2, 0, 0))
        sun.keyframe_insert("rotation_euler", frame=1)
        sun.rotation_euler.x = -numpy.pi / 2
        sun.keyframe_insert("rotation_euler", frame=10)
        self.scene.frame_set(1)
        first = self.shadow()
        self.scene.frame_set(10)
        self.assertEqual(attribute(self.hair.data).tobytes(), first.tobytes())
        self.hair.libhair.shadow_follows = True
        self.scene.frame_set(9)
        self.scene.frame_set(10)
        last = attribute(self.hair.data)
        near = self.local[:, 1] < 0.03
        self.assertGreater(first[near, 0].mean() - last[near, 0].mean(), 0.3)
        self.scene.frame_set(1)
        self.assertEqual(attribute(self.hair.data).tobytes(), first.tobytes())

    def test_the_head_below_is_dark_and_beside_it_is_lit(self):
        light("SUN")
        bpy.ops.mesh.primitive_grid_add(
            x_subdivisions=20, y_subdivisions=20, size=0.8, location=(0.6, -0.9, 0.9)
        )
        plate = bpy.context.object
        self.hair.libhair.head = plate
        self.hair.libhair.shadow_on_head = True
        self.shadow()
        shown = attribute(plate.data)[:, 0]
        place = numpy.array([v.co for v in plate.data.vertices])[:, :2]
        below = numpy.abs(place).max(axis=1) < 0.07
        beside = numpy.abs(place).max(axis=1) > 0.2
        self.assertLess(shown[below].mean(), 0.9)
        self.assertEqual(shown[beside].min(), 1)


run(Shadow)
