"""Strands of hair in Blender's objects: Curves, poly curves, and meshes that are chains of edges."""

import bpy
import numpy

from libhair import Error

REST = "libhair_rest"  # attribute: positions as they were before the simulation


def is_hair(obj):
    """Whether the object is of a type that may hold strands; `read` says whether it does."""
    return obj is not None and obj.type in {"CURVES", "CURVE", "MESH"}


def read(obj):
    """Points (N, 3) float32 in the object's space, first (S + 1,) uint32, radius (N,) or None.

    Of a Curves object the points are those at rest, whatever frame is shown. Error for what are
    no strands.
    """
    if obj is None or not is_hair(obj):
        kind = "nothing" if obj is None else f"'{obj.name}' of type {obj.type}"
        raise Error(f"{kind} is no hair: select Curves, a poly curve, or a mesh of edges")
    reader = {"CURVES": _read_curves, "CURVE": _read_poly, "MESH": _read_edges}[obj.type]
    points, first, radius = reader(obj)
    if len(first) < 2:
        raise Error(f"'{obj.name}' has no strands")
    return points, first, radius


def get(data, name, field, shape, dtype=numpy.float32):
    """An attribute's values."""
    values = numpy.empty(shape, dtype)
    data.attributes[name].data.foreach_get(field, values.reshape(-1))
    return values


def _first_of(counts):
    return numpy.concatenate(([0], numpy.cumsum(counts))).astype(numpy.uint32)


def _read_curves(obj):
    data = obj.data
    count = len(data.points)
    if not count:
        return numpy.empty((0, 3), numpy.float32), numpy.zeros(1, numpy.uint32), None
    if "curve_type" in data.attributes:
        types = get(data, "curve_type", "value", len(data.curves), numpy.int32)
        if (types > 1).any():
            raise Error(
                f"'{obj.name}' has Bezier or NURBS curves, whose points are not on them: "
                "set the curves' type to Poly"
            )
    lengths = numpy.empty(len(data.curves), numpy.int32)
    data.curves.foreach_get("points_length", lengths)
    points = get(data, REST if REST in data.attributes else "position", "vector", (count, 3))
    radius = get(data, "radius", "value", count) if "radius" in data.attributes else None
    return points, _first_of(lengths), radius


def _read_poly(obj):
    splines = obj.data.splines
    bad = {s.type for s in splines if s.type != "POLY"}
    if bad:
        raise Error(
            f"'{obj.name}' has {' and '.join(sorted(bad))} splines: set their type to Poly "
            "(Edit Mode > Curve > Set Spline Type)"
        )
    counts = [len(s.points) for s in splines]
    points = numpy.empty((sum(counts), 4), numpy.float32)
    radius = numpy.empty(sum(counts), numpy.float32)
    at = 0
    for spline, count in zip(splines, counts):
        spline.points.foreach_get("co", points[at : at + count].reshape(-1))
        spline.points.foreach_get("radius", radius[at : at + count])
        at += count
    # Blender's radius of a poly curve is a factor of its bevel.
    radius *= obj.data.bevel_depth
    return points[:, :3].copy(), _first_of(counts), radius if radius.any() else None


def _read_edges(obj):
    """Chains of edges, as particle hair becomes by "Convert to Mesh"; the root is the end that
    comes first among the vertices."""
    mesh = obj.data
    if len(mesh.polygons):
        raise Error(
            f"'{obj.name}' is a mesh with faces, not hair: select Curves, a poly curve, or a mesh "
            "of edges alone (particle hair: Convert to Mesh)"
        )
    edges = numpy.empty((len(mesh.edges), 2), numpy.int32)
    mesh.edges.foreach_get("vertices", edges.reshape(-1))
    points = numpy.empty((len(mesh.vertices), 3), numpy.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    neighbours = [[] for _ in range(len(points))]
    for a, b in edges:
        neighbours[a].append(b)
        neighbours[b].append(a)
    order, counts, seen = [], [], numpy.zeros(len(points), bool)
    for root, around in enumerate(neighbours):
        if len(around) > 2:
            raise Error(f"'{obj.name}': {len(around)} edges meet at vertex {root}; strands do not branch")
        if seen[root] or len(around) != 1:
            continue
        at, begin = root, len(order)
        while at is not None:
            seen[at] = True
            order.append(at)
            at = next((n for n in neighbours[at] if not seen[n]), None)
        counts.append(len(order) - begin)
    if not all(seen[i] or not around for i, around in enumerate(neighbours)):
        raise Error(f"'{obj.name}' has a ring of edges, which has no root; open it")
    return points[order], _first_of(counts), None


def write(obj, points):
    """The points of a Curves object, (N, 3) float32 in its space."""
    obj.data.attributes["position"].data.foreach_set("vector", points.reshape(-1))
    obj.data.update_tag()


def make(context, name, points, first, radius):
    """A new Curves object of strands in its own space, selected and active.

    Blender 3.4 has no call that adds points to Curves, but makes them from poly curves.
    """
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    co = numpy.ones((len(points), 4), numpy.float32)
    co[:, :3] = points
    radii = numpy.broadcast_to(numpy.asarray(radius, numpy.float32), len(points)).copy()
    for begin, end in zip(first[:-1].tolist(), first[1:].tolist()):
        spline = data.splines.new("POLY")
        spline.points.add(end - begin - 1)
        spline.points.foreach_set("co", co[begin:end].reshape(-1))
        spline.points.foreach_set("radius", radii[begin:end])
    obj = bpy.data.objects.new(name, data)
    context.collection.objects.link(obj)
    if context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    for other in context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    bpy.ops.object.convert(target="CURVES")
    hair = context.view_layer.objects.active
    hair.data.name = name
    set_attribute(hair.data, "radius", "FLOAT", "value", radii)
    if data.users == 0:
        bpy.data.curves.remove(data)
    return hair


def set_attribute(data, name, kind, field, values):
    """A point attribute, made where it is not there."""
    attribute = data.attributes.get(name)
    if attribute is not None and (attribute.data_type != kind or attribute.domain != "POINT"):
        data.attributes.remove(attribute)
        attribute = None
    if attribute is None:
        attribute = data.attributes.new(name, kind, "POINT")
    attribute.data.foreach_set(field, numpy.ascontiguousarray(values, numpy.float32).reshape(-1))
    data.update_tag()


def keep_rest(obj):
    """Remembers the points, unless that was done before."""
    data = obj.data
    if REST not in data.attributes:
        points = get(data, "position", "vector", (len(data.points), 3))
        set_attribute(data, REST, "FLOAT_VECTOR", "vector", points)


def give_back_rest(obj):
    """The points as they were, to the bit."""
    data = obj.data
    if REST in data.attributes:
        write(obj, get(data, REST, "vector", (len(data.points), 3)))
        data.attributes.remove(data.attributes[REST])
