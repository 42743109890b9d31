"""Writes what hair leaves of the scene's light as colour attributes, which materials read."""

import math

import bpy
import numpy

import libhair
from libhair import Error

from . import axes, curves
from .operators import reported
from .rig import head_of

NAME = "shadow"


def lights_of(scene, graph):
    """(name, Light of libhair) of every light that is rendered. Its colour is its share: of a sun
    its strength, of others what arrives at one metre."""
    scale, lights = axes.scale_of(scene), []
    for obj in scene.objects:
        if obj.type != "LIGHT" or obj.hide_render:
            continue
        now = obj.evaluated_get(graph)
        matrix = axes.place(now.matrix_world, scale)
        lamp = now.data
        if lamp.type == "SUN":
            # A light of Blender's shines along its -Z, which is libhair's -Y.
            colour = lamp.energy * numpy.array(lamp.color)
            light = libhair.Light.parallel(tuple(-matrix[:3, 1]), tuple(colour))
        else:
            colour = lamp.energy * numpy.array(lamp.color) / (4 * math.pi)
            light = libhair.Light.point(tuple(matrix[:3, 3]), tuple(colour))
        lights.append((obj.name, light))
    if not lights:
        raise Error("the scene has no light that is rendered: add a sun, a point or a spot light")
    return lights


def fibre_of(hair, radius, strand_count, scale):
    ours = hair.libhair
    width = ours.width
    if ours.width_from_radius:
        if radius is None or not radius.mean() > 0:
            raise Error(f"'{hair.name}' has no radius; switch Width from Radius off")
        width = 2 * float(radius.mean())
    return libhair.Fibre(
        width=width * scale, opacity=ours.opacity, hairs_per_strand=ours.hairs / strand_count
    )


def compute(hair, scene, graph, at=None):
    """{name of a light: (N,) transmittance} and all of them together (N, 3), as the hair is shown.

    at: (M, 3) float32, metres, libhair's world; the hair's own points where it is not given.
    """
    if hair.type != "CURVES":
        raise Error(f"'{hair.name}' has no attributes: convert it to Curves (Hair > To Curves)")
    scale = axes.scale_of(scene)
    _, first, radius = curves.read(hair)
    local = curves.get(hair.data, "position", "vector", (len(hair.data.points), 3))
    matrix = numpy.array(hair.evaluated_get(graph).matrix_world, float)
    points = axes.packed(axes.to_libhair(axes.move(matrix, local), scale))
    strands = libhair.Strands(points, first)
    pivot = points[first[:-1]].mean(axis=0, dtype=float)
    fibre = fibre_of(hair, radius, len(first) - 1, scale)
    each, lit, most = {}, 0, 0
    for name, light in lights_of(scene, graph):
        share = libhair.shadow(
            strands, light, hair.libhair.footprint * scale, fibre=fibre, pivot=tuple(pivot), at=at
        )
        each[name] = share
        strength = numpy.array(light.colour)
        if light.kind == "point":
            strength = strength / numpy.sum((numpy.array(light.position) - pivot) ** 2)
        lit = lit + share[:, None] * strength
        most = most + strength
    # A channel without light has the mean of all lights.
    plain = numpy.mean(list(each.values()), axis=0)[:, None]
    together = numpy.where(most > 0, lit / numpy.where(most > 0, most, 1), plain)
    return each, together


def _write(data, each, together):
    def colour(values):
        rgba = numpy.ones((len(values), 4), numpy.float32)
        rgba[:, :3] = values if values.ndim == 2 else values[:, None]
        return rgba

    wanted = {NAME: together}
    if len(each) > 1:
        wanted.update({f"{NAME}.{name}": share for name, share in each.items()})
    for name in [a.name for a in data.attributes]:
        if name.startswith(NAME + ".") and name not in wanted:
            data.attributes.remove(data.attributes[name])
    for name, values in wanted.items():
        curves.set_attribute(data, name, "FLOAT_COLOR", "color", colour(values))


def write(hair, scene, graph):
    """Attribute `shadow`, and where there are several lights, `shadow.<light>` of each."""
    each, together = compute(hair, scene, graph)
    on_head = None
    if hair.libhair.shadow_on_head:
        head, _ = head_of(hair)
        if head.type != "MESH":
            raise Error(f"head '{head.name}' is no mesh; switch On the Head Too off")
        local = numpy.empty((len(head.data.vertices), 3), numpy.float32)
        head.data.vertices.foreach_get("co", local.reshape(-1))
        world = axes.move(head.evaluated_get(graph).matrix_world, local)
        world = axes.packed(axes.to_libhair(world, axes.scale_of(scene)))
        on_head = head.data, *compute(hair, scene, graph, world)
    # All is known: from here nothing fails.
    _write(hair.data, each, together)
    if on_head:
        _write(*on_head)


class LIBHAIR_OT_shadow(bpy.types.Operator):
    """Write what the active hair leaves of the scene's lights as the colour attribute "shadow\""""

    bl_idname = "libhair.shadow"
    bl_label = "Shadow"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return curves.is_hair(context.object) and context.mode == "OBJECT"

    @reported
    def execute(self, context):
        write(context.object, context.scene, context.evaluated_depsgraph_get())
        return {"FINISHED"}


def register():
    bpy.utils.register_class(LIBHAIR_OT_shadow)


def unregister():
    bpy.utils.unregister_class(LIBHAIR_OT_shadow)
