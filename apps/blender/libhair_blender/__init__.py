"""Hair of libhair in Blender: moved along the scene's frames, shadowed, grown from hair meshes.

Needs the Python package libhair, which Blender looks for where its Python does, and in the folder
that the add-on's preferences name. Without it nothing but the preferences is there, and they say
what is missing.
"""

bl_info = {
    "name": "libhair",
    "author": "the libhair authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Hair",
    "description": "Hair simulated and shadowed on the CPU",
    "category": "Object",
}

import importlib
import sys

import bpy

# All that needs libhair, in the order of registration.
_MODULES = ("settings", "simulate", "shadow", "grow", "playback", "panel")
_loaded = []
_missing = ""


def connect():
    """Registers all that needs libhair, once it can be imported. Returns what is missing, or ""."""
    global _missing
    if _loaded:
        return ""
    try:
        import libhair  # noqa: F401
    except ImportError as error:
        _missing = str(error)
        return _missing
    _missing = ""
    for name in _MODULES:
        module = importlib.import_module("." + name, __name__)
        module.register()
        _loaded.append(module)
    return ""


def _use_folder(preferences, _context):
    folder = bpy.path.abspath(preferences.package_folder)
    if folder and folder not in sys.path:
        sys.path.append(folder)
        importlib.invalidate_caches()
    connect()


class HairPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    package_folder: bpy.props.StringProperty(
        name="Folder of the package",
        description="Folder that holds the folder libhair, such as <build>/python; only needed "
        "where Blender's Python does not find the package by itself",
        subtype="DIR_PATH",
        update=_use_folder,
    )

    def draw(self, _context):
        column = self.layout.column()
        for line in status():
            column.label(text=line, icon="ERROR" if _missing else "CHECKMARK")
        column.prop(self, "package_folder")


def status():
    """Lines that say whether libhair is there, and if not, how it gets there."""
    if not _missing:
        import libhair

        return [f"libhair {libhair.__version__}, {libhair.thread_count()} threads"]
    return [
        f"The Python package libhair was not found: {_missing}",
        f"It must be built for Python {sys.version_info[0]}.{sys.version_info[1]}, which this Blender uses.",
        "Debian: install python3-libhair, or build libhair and set the folder below to <build>/python.",
        "Anywhere: start Blender with PYTHONPATH=<build>/python.",
    ]


def register():
    bpy.utils.register_class(HairPreferences)
    addon = bpy.context.preferences.addons.get(__name__)
    if addon and addon.preferences:
        _use_folder(addon.preferences, None)
    if connect():
        print("libhair:", *status(), sep="\n  ")


def unregister():
    while _loaded:
        _loaded.pop().unregister()
    bpy.utils.unregister_class(HairPreferences)
