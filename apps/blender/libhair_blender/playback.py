"""Shows the frame of the cache that the scene shows."""

import contextlib

import bpy

from libhair import Error

from . import cache, curves, insides, shadow

_silent = 0


@contextlib.contextmanager
def silent():
    """Frames may change inside without hair that follows."""
    global _silent
    _silent += 1
    try:
        yield
    finally:
        _silent -= 1


def show(hair, scene):
    """Puts the points of the scene's frame into the object."""
    frames = cache.reader(bpy.path.abspath(hair.libhair.cache_path))
    if frames.point_count != len(hair.data.points):
        raise Error(
            f"'{hair.name}' has {len(hair.data.points)} points, its cache {frames.point_count}: "
            "simulate again, or free the cache"
        )
    curves.write(hair, frames.points(scene.frame_current_final))


@bpy.app.handlers.persistent
def on_frame(scene, graph=None):
    if _silent:
        return
    for hair in scene.objects:
        ours = hair.libhair
        if hair.type != "CURVES" or not (ours.cache_path or ours.shadow_follows):
            continue
        try:
            if ours.cache_path:
                show(hair, scene)
                insides.show(hair, scene, make=False)
            if ours.shadow_follows and graph is not None:
                shadow.write(hair, scene, graph)
            message = ""
        except Error as error:
            message = str(error)
        if message != ours.message:
            ours.message = message
            if message:
                print("libhair:", message)


def register():
    bpy.app.handlers.frame_change_post.append(on_frame)


def unregister():
    bpy.app.handlers.frame_change_post.remove(on_frame)
