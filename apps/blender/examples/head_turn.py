"""A bob on a head that turns, at three frames, lit through the attribute `shadow`.

usage: blender -b --factory-startup -P head_turn.py -- OUT.png

The scene is made with the add-on's own operators: Open Hair Mesh, Simulate, Shadow. Cycles computes
no shadows of hair here: what darkens it, and the head below it, is the attribute.
"""

import math
import pathlib
import sys
import tempfile

import bpy
import numpy

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
bpy.ops.preferences.addon_enable(module="libhair_blender")
import libhair  # noqa: E402
from libhair_blender import axes, curves  # noqa: E402

OUT = sys.argv[sys.argv.index("--") + 1]
FRAMES = (12, 20, 28)  # before the turn, in it, and after it
SIZE = (220, 272)  # pixels of each


def mesh_object(name, mesh, material):
    """An object of a mesh of libhair's."""
    data = bpy.data.meshes.new(name)
    data.from_pydata(axes.from_libhair(mesh.positions).tolist(), [], mesh.triangles.tolist())
    data.polygons.foreach_set("use_smooth", numpy.ones(len(data.polygons), bool))
    data.materials.append(material)
    obj = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(obj)
    return obj


def shadowed(name, shader, values):
    """A material that shows its shader where light arrives, and a little of it where none does."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    lit = nodes.new(shader)
    for key, value in values.items():
        lit.inputs[key].default_value = value
    attribute = nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = "shadow"
    share = nodes.new("ShaderNodeMapRange")
    share.inputs["To Min"].default_value = 0.08
    dark = nodes.new("ShaderNodeEmission")
    dark.inputs["Strength"].default_value = 0
    mix, out = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeOutputMaterial")
    links.new(attribute.outputs["Fac"], share.inputs["Value"])
    links.new(share.outputs["Result"], mix.inputs[0])
    links.new(dark.outputs[0], mix.inputs[1])
    links.new(lit.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], out.inputs["Surface"])
    return material


def point_at(obj, target):
    way = bpy.data.objects.new("target", None)
    way.location = target
    obj.rotation_euler = (way.location - obj.location).to_track_quat("-Z", "Y").to_euler()
    bpy.data.objects.remove(way)


def build():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="libhair_blender")
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, FRAMES[-1]
    skin = shadowed(
        "skin",
        "ShaderNodeBsdfPrincipled",
        {"Base Color": (0.58, 0.40, 0.31, 1), "Roughness": 0.6, "Specular": 0.3},
    )
    head = mesh_object("head", libhair.builtin_head(), skin)

    bpy.ops.libhair.open_hair_mesh(filepath=str(HERE.parents[3] / "models" / "bob.hairmesh"))
    hair = bpy.context.object
    hair.parent = head
    hair.data.materials.append(
        shadowed(
            "hair",
            "ShaderNodeBsdfHairPrincipled",
            {"Color": (0.14, 0.04, 0.012, 1), "Roughness": 0.45},
        )
    )
    hair.visible_shadow = False
    # A strand stands for ten hairs: drawn wider, so that they cover what those would.
    count = len(hair.data.points)
    curves.set_attribute(hair.data, "radius", "FLOAT", "value", numpy.full(count, 1.6e-4))

    # The head looks to one side, then turns to the other in a third of a second.
    for frame, degrees in ((1, -40), (13, -40), (21, 40)):
        head.rotation_euler.z = math.radians(degrees)
        head.keyframe_insert("rotation_euler", frame=frame)

    bpy.ops.object.light_add(type="SUN", location=(-2.2, -1.2, 1.6))
    sun = bpy.context.object
    sun.data.energy, sun.data.angle = 6, 0.02
    point_at(sun, (0, 0, 0))
    world = scene.world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.55, 0.62, 0.72, 1)
    world.node_tree.nodes["Background"].inputs[1].default_value = 0.5
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location = (0, -1.35, 0.14)
    camera.data.lens = 125
    point_at(camera, (0, 0, 0.05))
    scene.camera = camera
    return scene, head, hair


def move_and_shadow(scene, hair, folder):
    ours = hair.libhair
    ours.cache_folder = folder
    ours.shadow_follows = ours.shadow_on_head = True
    bpy.context.view_layer.objects.active = hair
    hair.select_set(True)
    bpy.ops.libhair.simulate()


def render(scene, folder):
    """[H, W, 4] of the three frames side by side."""
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.seed = "CPU", 144, 1
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    pictures = []
    for frame in FRAMES:
        scene.frame_set(frame)
        scene.render.filepath = f"{folder}/{frame}.png"
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        pixels = numpy.empty(SIZE[0] * SIZE[1] * 4, numpy.float32)
        image.pixels.foreach_get(pixels)
        pictures.append(pixels.reshape(SIZE[1], SIZE[0], 4))
    return numpy.concatenate(pictures, axis=1)


def save(pixels, path):
    image = bpy.data.images.new("frames", pixels.shape[1], pixels.shape[0], alpha=False)
    image.pixels.foreach_set(numpy.ascontiguousarray(pixels).reshape(-1))
    image.file_format = "PNG"
    image.filepath_raw = path
    image.save()


with tempfile.TemporaryDirectory() as folder:
    scene, head, hair = build()
    move_and_shadow(scene, hair, folder)
    save(render(scene, folder), OUT)
print("wrote", OUT)
