"""A small scene that tests share, and how a test file runs inside Blender."""

import os
import pathlib
import sys
import tempfile
import unittest

import bpy
import numpy

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MODELS = SOURCE / "models"
CENTRE, RADIUS = numpy.array([0.3, -0.2, 1.6]), 0.1


def run(*cases):
    """Runs test cases with the add-on on, and leaves Blender with an exit code."""
    sys.path.insert(0, str(SOURCE / "apps" / "blender"))
    bpy.ops.preferences.addon_enable(module="libhair_blender")
    suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(c) for c in cases)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)


def empty_scene(frames=60):
    """Nothing in it; frames of 1/24 s from 1, a cache folder of its own."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="libhair_blender")
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, frames
    scene.frame_set(1)
    return scene


def sphere(name="head", centre=CENTRE, radius=RADIUS):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=radius, location=centre)
    obj = bpy.context.object
    obj.name = name
    return obj


def turn(obj, degrees, first, last):
    """Turns about the vertical from one frame to another, and stands still before and after."""
    start = obj.rotation_euler.z
    obj.keyframe_insert("rotation_euler", frame=first)
    obj.rotation_euler.z = start + numpy.radians(degrees)
    obj.keyframe_insert("rotation_euler", frame=last)
    obj.rotation_euler.z = start


def lock(strands=120, points=12, length=0.15, seed=1):
    """(S, P, 3) float32 about the origin: strands that leave a sphere and hang down beside it."""
    random = numpy.random.default_rng(seed)
    around = random.uniform(0, 2 * numpy.pi, strands)
    down = numpy.radians(random.uniform(60, 85, strands))
    out = numpy.stack([numpy.cos(around), numpy.sin(around), numpy.zeros(strands)], axis=-1)
    roots = RADIUS * (numpy.sin(down)[:, None] * out + numpy.cos(down)[:, None] * [0, 0, 1])
    t = numpy.linspace(0, 1, points)[None, :, None]
    leave = 0.03 * (1 - (1 - t) ** 3)
    hair = roots[:, None] + leave * out[:, None] - t**2 * [0, 0, length]
    return hair.astype(numpy.float32)


def hair_on(head, points=None, name="hair"):
    """A Curves object of strands (S, P, 3) that is parented to the head, at its place."""
    from libhair_blender import curves

    points = lock() if points is None else points
    first = numpy.arange(len(points) + 1, dtype=numpy.uint32) * points.shape[1]
    hair = curves.make(bpy.context, name, points.reshape(-1, 3), first, 4e-5)
    if head:
        hair.parent = head
    bpy.context.view_layer.update()
    return hair


def select(obj):
    for other in bpy.context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj


def local_points(hair):
    from libhair_blender import curves

    return curves.get(hair.data, "position", "vector", (len(hair.data.points), 3))


def world_points(hair):
    """(N, 3) float64, Blender's axes, at the frame that is shown."""
    from libhair_blender import axes

    graph = bpy.context.evaluated_depsgraph_get()
    return axes.move(hair.evaluated_get(graph).matrix_world, local_points(hair))


def folder():
    return tempfile.TemporaryDirectory(prefix="libhair_blender_")


class Refusals:
    """For test cases: what an operator says when it refuses."""

    def assert_refused(self, words, operator, *args, **kwargs):
        try:
            operator(*args, **kwargs)
        except RuntimeError as error:
            self.assertRegex(str(error), words)
        else:
            self.fail(f"{operator} did not refuse")


def has_file(path):
    return os.path.exists(bpy.path.abspath(path))
