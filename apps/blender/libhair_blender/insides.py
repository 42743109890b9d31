"""The inside of a simulation as it is shown: an object of thin, coloured tubes, one a line.

Tubes, because Blender draws edges without their colours and renders none.
"""

import bpy
import numpy

from libhair import Error

from . import line_cache

COLOUR = "inside"  # attribute and material
_SIDES = 3

# What Simulation.lines knows: identifier, name (in lower case libhair's), meaning.
ITEMS = (
    ("GUIDES", "Guides", "Links of the simulated strands"),
    ("TENSION", "Tension", "Links of the guides: red where pulled, blue where pushed"),
    ("GUIDE_FRAMES", "Guide Frames", "Normal, binormal and tangent at guide points, 5 mm"),
    ("CONTACTS", "Contacts", "The collider's normal where a guide point touches it, 1 cm"),
    ("PUSH", "Push", "Of self-collision on guide points, 1 mm for 1 m/s²"),
    ("COLLIDERS", "Colliders", "Capsules, and contour lines of the head and other meshes"),
    ("BRICKS", "Bricks", "Occupied bricks of the density map of the scene's first light"),
)


def names_of(identifiers):
    """libhair's names, in its order."""
    return [name.lower() for identifier, name, _ in ITEMS if identifier in identifiers]


def missing(hair):
    """Names of what is on, but was not when the hair was simulated."""
    ours = hair.libhair
    if not ours.cache_path:
        return []
    kept = line_cache.reader(bpy.path.abspath(ours.cache_path))
    return [name for name in names_of(ours.insides) if kept is None or name not in kept.insides]


def show(hair, scene, make=True):
    """Brings the object of tubes to the scene's frame. make: makes it, or removes it where nothing is
    on; a change of frame must not."""
    ours = hair.libhair
    kept = line_cache.reader(bpy.path.abspath(ours.cache_path)) if ours.cache_path else None
    if make and (kept is None or not ours.insides):
        return remove(hair)
    if make and ours.insides_object is not None and not ours.insides_object.users_collection:
        remove(hair)  # a user has deleted it
    if make and ours.insides_object is None:
        ours.insides_object = _make(hair.name + ".insides", scene)
    if ours.insides_object is not None and kept is not None:
        lines = kept.lines(scene.frame_current_final, names_of(ours.insides))
        _fill(ours.insides_object.data, *lines, ours.insides_width)


def remove(hair):
    obj = hair.libhair.insides_object
    if obj is None:
        return
    data = obj.data
    hair.libhair.insides_object = None
    bpy.data.objects.remove(obj)
    if data.users == 0:
        bpy.data.meshes.remove(data)


def on_change(settings, context):
    """Update of a switch."""
    hair = settings.id_data
    if not settings.cache_path:
        return
    try:
        show(hair, context.scene)
        settings.message = ""
    except (Error, OSError) as error:
        settings.message = str(error)


def _make(name, scene):
    data = bpy.data.meshes.new(name)
    data.materials.append(_material())
    obj = bpy.data.objects.new(name, data)
    obj.hide_select = True
    scene.collection.objects.link(obj)  # not the hair's, which may be that of colliders
    return obj


def _material():
    """Light of the attribute's colour, whatever shines on it."""
    material = bpy.data.materials.get("libhair " + COLOUR)
    if material is None:
        material = bpy.data.materials.new("libhair " + COLOUR)
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        nodes.clear()
        attribute, glow = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeEmission")
        out = nodes.new("ShaderNodeOutputMaterial")
        attribute.attribute_name = COLOUR
        links.new(attribute.outputs["Color"], glow.inputs["Color"])
        links.new(glow.outputs["Emission"], out.inputs["Surface"])
    return material


def _tubes(positions, width):
    """Lines (2 n, 3) as (2 n, 3 sides, 3) corners of prisms about them."""
    ends = positions.reshape(-1, 2, 3).astype(float)
    along = ends[:, 1] - ends[:, 0]
    # At right angles to the line, from the axis that it is least along.
    axis = numpy.eye(3)[numpy.abs(along).argmin(axis=1)]
    u = numpy.cross(along, axis)
    u /= numpy.maximum(numpy.linalg.norm(u, axis=1, keepdims=True), 1e-20)
    v = numpy.cross(along, u)
    v /= numpy.maximum(numpy.linalg.norm(v, axis=1, keepdims=True), 1e-20)
    angle = 2 * numpy.pi / _SIDES * numpy.arange(_SIDES)
    ring = numpy.cos(angle)[:, None] * u[:, None] + numpy.sin(angle)[:, None] * v[:, None]
    return (ends[:, :, None] + width / 2 * ring[:, None]).reshape(-1, _SIDES, 3)


def _fill(data, positions, colours, width):
    """positions: (2 n, 3), the scene's units; colours: (2 n, 4) uint8, sRGB."""
    count = len(positions) // 2
    data.clear_geometry()
    if count:
        side = numpy.arange(_SIDES)
        following = (side + 1) % _SIDES
        quad = numpy.stack((side, following, following + _SIDES, side + _SIDES), axis=-1)
        corners = (quad + 2 * _SIDES * numpy.arange(count)[:, None, None]).reshape(-1)
        data.vertices.add(2 * _SIDES * count)
        data.loops.add(len(corners))
        data.polygons.add(len(corners) // 4)
        tubes = _tubes(positions, width)
        data.vertices.foreach_set("co", tubes.astype(numpy.float32).reshape(-1))
        data.loops.foreach_set("vertex_index", corners.astype(numpy.int32))
        data.polygons.foreach_set("loop_start", numpy.arange(0, len(corners), 4, dtype=numpy.int32))
        data.polygons.foreach_set("loop_total", numpy.full(len(corners) // 4, 4, numpy.int32))
        data.update(calc_edges=True)
        attribute = data.color_attributes.new(COLOUR, "FLOAT_COLOR", "POINT")
        linear = numpy.repeat(_linear(colours), _SIDES, axis=0)
        attribute.data.foreach_set("color", linear.astype(numpy.float32).reshape(-1))
        data.color_attributes.active_color = attribute
    data.update_tag()


def _linear(colours):
    """sRGB bytes as linear floats; opacity is as it was."""
    values = colours / 255.0
    rgb = values[:, :3]
    values[:, :3] = numpy.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return values
