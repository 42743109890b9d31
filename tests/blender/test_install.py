"""The zip file as a user installs it; first without libhair, which comes later.

The environment names the zip file (LIBHAIR_BLENDER_ZIP) and Blender's folder for add-ons, which is
the test's own (BLENDER_USER_SCRIPTS).
"""

import os
import sys
import traceback

import bpy


def check():
    zip_file = os.environ["LIBHAIR_BLENDER_ZIP"]
    scripts = os.environ["BLENDER_USER_SCRIPTS"]
    # As if there were no libhair, whatever is installed.
    found, sys.path[:] = list(sys.path), [
        p for p in sys.path if not os.path.isdir(os.path.join(p or ".", "libhair"))
    ]
    home = next(p for p in found if os.path.isdir(os.path.join(p or ".", "libhair")))

    bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
    installed = os.path.join(scripts, "addons", "libhair_blender")
    assert os.path.isfile(os.path.join(installed, "__init__.py")), installed
    bpy.ops.preferences.addon_enable(module="libhair_blender")
    import libhair_blender

    assert os.path.dirname(libhair_blender.__file__) == installed, libhair_blender.__file__
    words = "\n".join(libhair_blender.status())
    assert "libhair was not found: No module named 'libhair'" in words, words
    assert "python3-libhair" in words and "PYTHONPATH" in words, words
    assert not hasattr(bpy.types.Object, "libhair")

    # The folder in the preferences is enough.
    addon = bpy.context.preferences.addons["libhair_blender"]
    addon.preferences.package_folder = home
    assert libhair_blender.status()[0].startswith("libhair "), libhair_blender.status()
    assert hasattr(bpy.types.Object, "libhair") and hasattr(bpy.types, "LIBHAIR_PT_simulation")
    assert bpy.ops.libhair.simulate.get_rna_type().name == "Simulate"

    # Off, nothing is left; and on again.
    handlers = bpy.app.handlers.frame_change_post
    with_it = len(handlers)
    bpy.ops.preferences.addon_disable(module="libhair_blender")
    assert len(handlers) == with_it - 1
    assert not hasattr(bpy.types.Object, "libhair")
    bpy.ops.preferences.addon_enable(module="libhair_blender")
    assert len(handlers) == with_it
    bpy.ops.mesh.primitive_cube_add()
    try:
        bpy.ops.libhair.simulate()
    except RuntimeError as error:
        assert "is a mesh with faces, not hair" in str(error), error
    else:
        raise AssertionError("a cube was simulated")


try:
    check()
except BaseException:
    traceback.print_exc()
    sys.exit(1)
print("the add-on installs")
