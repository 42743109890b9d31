"""Head and colliders of Blender's scene, as a simulation is told of them at every frame.

A thing is taken as it is at the first frame and moves rigidly from there: where M is its matrix
then and M' now, it moved by M' M^-1, which is rigid whatever scale the object has, as long as that
stays. The head's space has the world's axes at the first frame and its origin amid the roots.
"""

import numpy

import libhair
from libhair import Error

from . import axes

_RIGID = 1e-3  # of a matrix's columns from length 1 and right angles, as libhair.Transform has it
_SHAPE = 1e-3  # metres that a collider's vertices may move in its own space


def _shift(origin):
    matrix = numpy.eye(4)
    matrix[:3, 3] = origin
    return matrix


class _Follower:
    """An object, or a bone of it, and where it was at the first frame."""

    def __init__(self, obj, bone, scale, graph):
        self.obj, self.bone, self.scale = obj, bone, scale
        self.name = f"'{obj.name}'" + (f", bone '{bone}'" if bone else "")
        self.start = self._matrix(graph)
        if not abs(numpy.linalg.det(self.start[:3, :3])) > 1e-12:
            raise Error(f"{self.name} has scale 0 along an axis")

    def _matrix(self, graph):
        now = self.obj.evaluated_get(graph)
        matrix = now.matrix_world
        if self.bone:
            matrix = matrix @ now.pose.bones[self.bone].matrix
        return axes.place(matrix, self.scale)

    def motion(self, graph):
        """(4, 4): from where it was to where it is."""
        matrix = self._matrix(graph) @ numpy.linalg.inv(self.start)
        if numpy.abs(matrix[:3, :3].T @ matrix[:3, :3] - numpy.eye(3)).max() > _RIGID:
            raise Error(
                f"{self.name} changes its size at frame {graph.scene.frame_current}: "
                "what hair is on, or meets, may only move and turn"
            )
        return matrix


class _MeshShape:
    """An evaluated mesh; says when it is no longer the same."""

    def __init__(self, obj, scale, graph):
        self.obj, self.scale = obj, scale
        self.may_change = bool(obj.modifiers or obj.data.shape_keys)
        self.local, self.triangles = self._read(graph, triangles=True)
        if not len(self.triangles):
            raise Error(f"'{obj.name}' has no faces, so nothing can collide with it")

    def _read(self, graph, triangles=False):
        now = self.obj.evaluated_get(graph)
        mesh = now.to_mesh()
        try:
            local = numpy.empty((len(mesh.vertices), 3), numpy.float32)
            mesh.vertices.foreach_get("co", local.reshape(-1))
            corners = None
            if triangles:
                mesh.calc_loop_triangles()
                corners = numpy.empty((len(mesh.loop_triangles), 3), numpy.int32)
                mesh.loop_triangles.foreach_get("vertices", corners.reshape(-1))
            return local, corners
        finally:
            now.to_mesh_clear()

    def field(self, matrix, origin, detail):
        """Its DistanceField at a place, in metres from `origin`."""
        world = axes.move(matrix, axes.to_libhair(self.local, self.scale))
        # Which of three directions is thin does not depend on how the mesh is turned.
        spread = numpy.linalg.svd(world - world.mean(axis=0), compute_uv=False)
        if not spread[2] > 1e-4 * spread[0]:
            raise Error(f"'{self.obj.name}' is flat: what keeps hair out must have an inside (Solidify)")
        triangles = self.triangles if numpy.linalg.det(matrix[:3, :3]) > 0 else self.triangles[:, ::-1]
        mesh = libhair.Mesh(
            axes.packed(world - origin), numpy.ascontiguousarray(triangles, numpy.uint32)
        )
        try:
            return libhair.DistanceField(mesh, cell=detail * self.scale)
        except Error as error:
            raise Error(f"'{self.obj.name}': {error}") from error

    def check(self, graph):
        if not self.may_change:
            return
        local, _ = self._read(graph)
        moved = (
            numpy.abs(local - self.local).max() * self.scale
            if local.shape == self.local.shape
            else numpy.inf
        )
        if moved > _SHAPE:
            raise Error(
                f"'{self.obj.name}' changes its shape at frame {graph.scene.frame_current}: a mesh "
                "that keeps hair out may only move and turn; use the capsules of an armature (Body)"
            )


class _Collider:
    def __init__(self, obj, detail, scale, graph):
        self.follower = _Follower(obj, "", scale, graph)
        self.shape = _MeshShape(obj, scale, graph)
        box = axes.move(self.follower.start, axes.to_libhair(self.shape.local, scale))
        self.origin = (box.min(axis=0) + box.max(axis=0)) / 2
        self.field = self.shape.field(self.follower.start, self.origin, detail)

    def now(self, graph):
        self.shape.check(graph)
        return libhair.MeshCollider(self.field, self.follower.motion(graph) @ _shift(self.origin))


class _Body:
    """Capsules along an armature's deforming bones."""

    def __init__(self, obj, left_out, scale):
        self.obj, self.scale = obj, scale
        self.bones = [
            bone.name
            for bone in obj.data.bones
            if bone.use_deform and bone.name != left_out and bone.head_radius + bone.tail_radius > 0
        ]
        if not self.bones:
            raise Error(f"'{obj.name}' has no deforming bone with a radius that hair could meet")

    def now(self, graph):
        now = self.obj.evaluated_get(graph)
        matrix = axes.place(now.matrix_world, self.scale)
        grown = abs(numpy.linalg.det(matrix[:3, :3])) ** (1 / 3) * self.scale
        ends = numpy.array(
            [(*now.pose.bones[name].head, *now.pose.bones[name].tail) for name in self.bones]
        ).reshape(-1, 3)
        radii = [
            grown * (bone.head_radius + bone.tail_radius) / 2
            for bone in (self.obj.data.bones[name] for name in self.bones)
        ]
        world = axes.move(matrix, axes.to_libhair(ends, self.scale)).reshape(-1, 6)
        return numpy.column_stack((world, radii)).astype(numpy.float32)


def head_of(hair):
    """The object that carries the hair and the bone's name, or ""."""
    settings = hair.libhair
    surface = getattr(hair.data, "surface", None)
    if settings.head:
        obj, bone = settings.head, settings.bone
    elif surface:
        obj, bone = surface, ""
    elif hair.parent:
        obj = hair.parent
        bone = settings.bone or (hair.parent_bone if hair.parent_type == "BONE" else "")
    else:
        raise Error(f"'{hair.name}' is on no head: choose one in the Hair panel, or set a parent")
    if obj == hair:
        raise Error(f"'{hair.name}' cannot be its own head")
    if obj.type != "ARMATURE":
        return obj, ""
    if not bone:
        raise Error(f"head '{obj.name}' is an armature: choose the bone that carries the hair")
    if bone not in obj.pose.bones:
        raise Error(f"armature '{obj.name}' has no bone '{bone}'")
    return obj, bone


class Rig:
    """Made at the first frame. roots: (S, 3), metres, libhair's world."""

    def __init__(self, hair, roots, scene, graph):
        settings, scale = hair.libhair, axes.scale_of(scene)
        head, bone = head_of(hair)
        self.follower = _Follower(head, bone, scale, graph)
        self.origin = roots.mean(axis=0)
        self.head_shape, self.field = None, None
        if settings.collide_head and head.type == "MESH":
            self.head_shape = _MeshShape(head, scale, graph)
            self.field = self.head_shape.field(self.follower.start, self.origin, settings.detail)
        self.body = None
        if settings.body:
            self.body = _Body(settings.body, bone if settings.body == head else "", scale)
        meshes = settings.colliders.all_objects if settings.colliders else ()
        self.colliders = [
            _Collider(obj, settings.detail, scale, graph)
            for obj in meshes
            if obj.type == "MESH" and obj not in (hair, head)
        ]

    def now(self, graph):
        """What Simulation, restart and step take."""
        if self.head_shape:
            self.head_shape.check(graph)
        place = {"world_from_head": self.follower.motion(graph) @ _shift(self.origin)}
        if self.body:
            place["capsules"] = self.body.now(graph)
        if self.colliders:
            place["meshes"] = [collider.now(graph) for collider in self.colliders]
        return place
