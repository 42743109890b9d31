"""Moves hair along the scene's frames and keeps every frame in a file."""

import os
import re
import time
import zlib

import bpy
import numpy

import libhair
from libhair import Error

from . import axes, cache, curves, insides, line_cache, playback
from .operators import reported
from .rig import Rig
from .settings import copy
from .shadow import lights_of


def frame_settings(hair, scene):
    """What libhair is told of an object's settings. No lights: shadows are apart (shadow.py)."""
    ours, scale = hair.libhair, axes.scale_of(scene)
    default = libhair.GuideSettings()
    gravity = scene.gravity if scene.use_gravity else (0, 0, 0)
    return libhair.FrameSettings(
        guides=default.replace(
            bending_stiffness=ours.stiffness * default.bending_stiffness,
            air_drag=ours.air_drag,
            friction=ours.friction,
            gravity=tuple(axes.to_libhair(gravity).tolist()),
        ),
        self_collision=ours.self_collision,
        wind=libhair.Wind(
            velocity=tuple(axes.to_libhair(ours.wind, scale).tolist()), gust=ours.gust
        ),
        lights=(),
        shadow=False,
        shade=False,
    )


def cache_file(hair):
    """Where the object's frames go: a file for each object of each .blend."""
    whole = f"{os.path.basename(bpy.data.filepath)} {hair.name}"
    plain = re.sub(r"[^\w.-]", "_", hair.name)
    name = f"{plain}.{zlib.crc32(whole.encode()):08x}.haircache"
    if hair.libhair.cache_folder:
        return os.path.join(bpy.path.abspath(hair.libhair.cache_folder), name)
    folder = bpy.path.abspath("//") if bpy.data.filepath else bpy.app.tempdir
    return os.path.join(folder, "libhair_cache", name)


class Run:
    """One simulation from the first frame to the last. Nothing of the scene is another until
    `finish`; `abandon` leaves no trace."""

    def __init__(self, context, hair):
        self.context, self.scene, self.hair = context, context.scene, hair
        self.scale = axes.scale_of(self.scene)
        self.back_to = self.scene.frame_current_final
        self.first, self.last = self.scene.frame_start, self.scene.frame_end
        self.rest, self.first_of, self.radius = curves.read(hair)
        self.insides = insides.names_of(hair.libhair.insides)
        self.writer = self.line_writer = None
        try:
            self._begin()
        except BaseException:
            self.abandon()
            raise

    def _go(self, frame):
        """Shows a frame without what was simulated before."""
        with playback.silent():
            self.scene.frame_set(int(frame), subframe=frame - int(frame))
        return self.context.evaluated_depsgraph_get()

    def _hair_matrix(self, graph):
        return numpy.array(self.hair.evaluated_get(graph).matrix_world, float)

    def _begin(self):
        graph = self._go(self.first)
        world = axes.to_libhair(axes.move(self._hair_matrix(graph), self.rest), self.scale)
        self.rig = Rig(self.hair, world[self.first_of[:-1]], self.scene, graph)
        strands = libhair.Strands(axes.packed(world - self.rig.origin), self.first_of)
        ours = self.hair.libhair
        groom = libhair.bind_groom(
            strands,
            libhair.BindSettings(guides=ours.guides, points_per_guide=ours.points_per_guide),
            hairs=ours.hairs,
        )
        place = self.rig.now(graph)
        self.simulation = libhair.Simulation(
            groom, self._settings(graph), head=self.rig.field, **place
        )
        self.simulation.restart(ours.settle, **place)
        path = cache_file(self.hair)
        self.writer = cache.Writer(path, self.first, len(self.rest))
        if self.insides:
            self.line_writer = line_cache.Writer(line_cache.file_of(path), self.first, self.insides)
        self._keep(graph)
        self.frame = self.first

    def _settings(self, graph):
        """Bricks are those of a light's map, which nothing else of a simulation needs."""
        settings = frame_settings(self.hair, self.scene)
        if "bricks" not in self.insides:
            return settings
        _, light = lights_of(self.scene, graph)[0]
        return settings.replace(lights=(light,), shadow=True)

    def _keep(self, graph):
        world = axes.from_libhair(self.simulation.points.astype(float), self.scale)
        self.writer.add(axes.packed(axes.move(numpy.linalg.inv(self._hair_matrix(graph)), world)))
        if self.line_writer:
            lines = [self.simulation.lines(name) for name in self.insides]
            self.line_writer.add(
                [(axes.from_libhair(ends, self.scale), colours) for ends, colours in lines]
            )

    @property
    def done(self):
        return self.frame >= self.last

    def step(self):
        """The next frame."""
        graph = self._go(self.frame + 1)
        fps = self.scene.render.fps / self.scene.render.fps_base
        if "bricks" in self.insides:
            self.simulation.settings = self._settings(graph)
        self.simulation.step(1 / fps, **self.rig.now(graph))
        self._keep(graph)
        self.frame += 1

    def finish(self):
        """Moves the hair; returns the Curves object that has it."""
        if self.line_writer:
            self.line_writer.finish()
        else:
            cache.remove(line_cache.file_of(self.writer.path))
        self.writer.finish()
        hair = self.hair
        if hair.type != "CURVES":
            hair = replace(self.context, self.hair, self.rest, self.first_of, self.radius)
        curves.keep_rest(hair)
        hair.libhair.cache_path = self.writer.path
        if bpy.data.filepath and not hair.libhair.cache_folder:
            hair.libhair.cache_path = bpy.path.relpath(self.writer.path)
        self._go(self.back_to)
        playback.show(hair, self.scene)
        insides.show(hair, self.scene)
        return hair

    def abandon(self):
        for writer in (self.writer, self.line_writer):
            if writer:
                writer.abandon()
        self._go(self.back_to)


def replace(context, source, points, first, radius):
    """A Curves object in the place of a poly curve or a mesh of edges, which is hidden."""
    if radius is None:
        radius = source.libhair.width / 2
    hair = curves.make(context, source.name + ".libhair", points, first, radius)
    hair.parent, hair.parent_type, hair.parent_bone = (
        source.parent,
        source.parent_type,
        source.parent_bone,
    )
    hair.matrix_parent_inverse = source.matrix_parent_inverse
    hair.matrix_basis = source.matrix_basis
    for material in source.data.materials:
        hair.data.materials.append(material)
    copy(source.libhair, hair.libhair)
    hair.libhair.source = source
    source.hide_viewport = source.hide_render = True
    return hair


class LIBHAIR_OT_simulate(bpy.types.Operator):
    """Simulate the active hair from the scene's first frame to its last. Esc stops and leaves \
everything as it was"""

    bl_idname = "libhair.simulate"
    bl_label = "Simulate"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return curves.is_hair(context.object) and context.mode == "OBJECT"

    @reported
    def execute(self, context):
        run = Run(context, context.object)
        try:
            while not run.done:
                run.step()
            self._finish(run)
        except BaseException:
            run.abandon()
            raise
        return {"FINISHED"}

    def _finish(self, run):
        hair = run.finish()
        where = hair.libhair.cache_path
        lost = "" if bpy.data.filepath or hair.libhair.cache_folder else " (goes when Blender does)"
        self.report({"INFO"}, f"{run.last - run.first + 1} frames of '{hair.name}' in {where}{lost}")

    def invoke(self, context, _event):
        if bpy.app.background:
            return self.execute(context)
        try:
            self.run = Run(context, context.object)
        except (Error, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(self.run.first, self.run.last)
        self.timer = manager.event_timer_add(0.01, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        try:
            if event.type == "ESC":
                self.run.abandon()
                self.report({"INFO"}, f"Stopped at frame {self.run.frame}; nothing was changed")
                return self._leave(context, {"CANCELLED"})
            if event.type != "TIMER":
                return {"RUNNING_MODAL"}
            # As many frames as fit between two looks at the keyboard.
            until = time.monotonic() + 0.1
            while not self.run.done and time.monotonic() < until:
                self.run.step()
            context.window_manager.progress_update(self.run.frame)
            if not self.run.done:
                return {"RUNNING_MODAL"}
            self._finish(self.run)
            return self._leave(context, {"FINISHED"})
        except Exception as error:
            self.run.abandon()
            self._leave(context, {"CANCELLED"})
            if not isinstance(error, (Error, OSError)):
                raise
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def _leave(self, context, result):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        return result


class LIBHAIR_OT_free_cache(bpy.types.Operator):
    """Forget the simulated frames: the hair is again as it was before"""

    bl_idname = "libhair.free_cache"
    bl_label = "Free Cache"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and bool(context.object.libhair.cache_path)

    @reported
    def execute(self, context):
        hair = context.object
        path = hair.libhair.cache_path
        if not any(o.libhair.cache_path == path for o in bpy.data.objects if o != hair):
            cache.remove(bpy.path.abspath(path))
            cache.remove(line_cache.file_of(bpy.path.abspath(path)))
        insides.remove(hair)
        hair.libhair.cache_path = hair.libhair.message = ""
        source = hair.libhair.source
        if source is None:
            curves.give_back_rest(hair)
            return {"FINISHED"}
        data = hair.data
        bpy.data.objects.remove(hair)
        if data.users == 0:
            bpy.data.hair_curves.remove(data)
        source.hide_viewport = source.hide_render = False
        if source.name in context.view_layer.objects:
            source.select_set(True)
            context.view_layer.objects.active = source
        return {"FINISHED"}


_CLASSES = (LIBHAIR_OT_simulate, LIBHAIR_OT_free_cache)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
