"""Curves from hair meshes, from poly curves and from meshes of edges."""

import os
import re
import tempfile

import bpy
import numpy
from bpy.props import FloatProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

import libhair
from libhair import Error

from . import axes, curves
from .operators import reported
from .simulate import replace


class _Growth:
    """What both ways to a hair mesh ask for."""

    strands: IntProperty(
        name="Strands", description="Of each group of strands. 0: what the hair mesh says", min=0
    )
    points: IntProperty(
        name="Points", description="Of a strand. 0: what the hair mesh says", min=0
    )
    hairs: FloatProperty(
        name="Hairs",
        description="Hairs that all strands stand for together",
        default=100_000,
        min=1,
        soft_max=300_000,
    )

    def grow(self, context, path, name):
        groom = libhair.hair_mesh_groom(
            path, strands=self.strands, points=self.points, hairs=self.hairs
        )
        # The strands at rest are those that a simulation draws before its first step.
        still = libhair.FrameSettings(lights=(), shadow=False, shade=False, self_collision=False)
        drawn = libhair.Simulation(groom, still)
        scale = axes.scale_of(context.scene)
        points = axes.packed(axes.from_libhair(drawn.points, scale))
        width = groom.fibre.width / scale
        hair = curves.make(context, name, points, drawn.first, width / 2)
        hair.libhair.hairs, hair.libhair.width = self.hairs, width
        self.report({"INFO"}, f"{len(drawn.first) - 1} strands, {len(points)} points")
        return hair


class LIBHAIR_OT_open_hair_mesh(bpy.types.Operator, ImportHelper, _Growth):
    """Grow hair from a hair mesh: a script (.hairmesh), or layers (.obj)"""

    bl_idname = "libhair.open_hair_mesh"
    bl_label = "Open Hair Mesh"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: StringProperty(default="*.hairmesh;*.obj", options={"HIDDEN"})

    @reported
    def execute(self, context):
        name = os.path.splitext(os.path.basename(self.filepath))[0]
        self.grow(context, bpy.path.abspath(self.filepath), name or "hair")
        return {"FINISHED"}


def _layer_number(obj):
    """layer_2 and layer_2.001 are layer 2; other names go by the alphabet, after those."""
    match = re.match(r"layer_(\d+)", obj.name)
    return (0, int(match[1]), obj.name) if match else (1, 0, obj.name)


def layers_as_obj(layers, scene, graph):
    """The text of an OBJ file with one object a layer, from the scalp out; metres, +Y up.

    Faces and corners are in the meshes' order, which says what belongs together.
    """
    scale, lines, before = axes.scale_of(scene), [], 1
    for number, obj in enumerate(layers):
        mesh = obj.data
        local = numpy.empty((len(mesh.vertices), 3), numpy.float32)
        mesh.vertices.foreach_get("co", local.reshape(-1))
        world = axes.to_libhair(axes.move(obj.evaluated_get(graph).matrix_world, local), scale)
        lines.append(f"o layer_{number}")
        lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in axes.packed(world).tolist()]
        lines += [
            "f " + " ".join(str(v + before) for v in polygon.vertices) for polygon in mesh.polygons
        ]
        before += len(local)
    return "\n".join(lines) + "\n"


class LIBHAIR_OT_grow(bpy.types.Operator, _Growth):
    """Grow hair from the selected meshes, which are the layers of a hair mesh: by number where \
they are called layer_0, layer_1 and so on (layer_0 is the scalp), else by name"""

    bl_idname = "libhair.grow"
    bl_label = "Grow from Layers"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and any(o.type == "MESH" for o in context.selected_objects)

    @reported
    def execute(self, context):
        layers = sorted((o for o in context.selected_objects if o.type == "MESH"), key=_layer_number)
        if len(layers) < 2:
            raise Error("a hair mesh has two layers or more: select a mesh for each, the scalp first")
        text = layers_as_obj(layers, context.scene, context.evaluated_depsgraph_get())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "layers.obj")
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
            try:
                self.grow(context, path, "hair")
            except Error as error:
                # The file is gone when this is read; what is numbered in it are the layers.
                words = str(error).replace(path, "the layers")
                raise Error(f"{words} ({', '.join(o.name for o in layers)})") from error
        return {"FINISHED"}


class LIBHAIR_OT_to_curves(bpy.types.Operator):
    """Make Curves of a poly curve, or of a mesh of edges (particle hair that was converted to a \
mesh); the original is hidden"""

    bl_idname = "libhair.to_curves"
    bl_label = "To Curves"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.object is not None and (
            context.object.type in {"CURVE", "MESH"}
        )

    @reported
    def execute(self, context):
        hair = replace(context, context.object, *curves.read(context.object))
        # Kept for good: what frees the cache does not bring the original back.
        hair.libhair.source = None
        return {"FINISHED"}


_CLASSES = (LIBHAIR_OT_open_hair_mesh, LIBHAIR_OT_grow, LIBHAIR_OT_to_curves)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
