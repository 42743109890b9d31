"""The tab "Hair" in the sidebar of the 3D view."""

import bpy

from . import cache, curves, insides


class _Tab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Hair"


class _HairTab(_Tab):
    """Panels of a hair object."""

    @classmethod
    def poll(cls, context):
        return curves.is_hair(context.object)


class LIBHAIR_PT_simulation(_HairTab, bpy.types.Panel):
    bl_label = "Simulation"

    def draw(self, context):
        hair = context.object
        ours = hair.libhair
        layout = self.layout
        layout.use_property_split = True
        column = layout.column()
        column.prop(ours, "head")
        head = ours.head or getattr(hair.data, "surface", None) or hair.parent
        if head is not None and head.type == "ARMATURE":
            column.prop_search(ours, "bone", head.data, "bones")
        else:
            column.prop(ours, "collide_head")
        column.prop(ours, "body")
        column.prop(ours, "colliders")
        column.prop(ours, "detail")
        column = layout.column()
        for name in ("guides", "points_per_guide", "settle", "stiffness", "air_drag", "friction"):
            column.prop(ours, name)
        column.prop(ours, "self_collision")
        column.prop(ours, "wind")
        column.prop(ours, "gust")
        layout.prop(ours, "cache_folder")
        row = layout.row()
        row.operator("libhair.simulate", icon="PLAY")
        row.operator("libhair.free_cache", icon="TRASH")
        if ours.message:
            layout.label(text=ours.message, icon="ERROR")
        elif ours.cache_path:
            try:
                frames = cache.reader(bpy.path.abspath(ours.cache_path))
                layout.label(text=f"Frames {frames.first_frame} to {frames.last_frame}")
            except ValueError as error:
                layout.label(text=str(error), icon="ERROR")


class LIBHAIR_PT_shadow(_HairTab, bpy.types.Panel):
    bl_label = "Shadow"

    def draw(self, context):
        ours = context.object.libhair
        layout = self.layout
        layout.use_property_split = True
        column = layout.column()
        column.prop(ours, "hairs")
        column.prop(ours, "width_from_radius")
        row = column.row()
        row.active = not ours.width_from_radius
        row.prop(ours, "width")
        column.prop(ours, "opacity")
        column.prop(ours, "footprint")
        column.prop(ours, "shadow_follows")
        column.prop(ours, "shadow_on_head")
        layout.operator("libhair.shadow", icon="LIGHT_SUN")


class LIBHAIR_PT_insides(_HairTab, bpy.types.Panel):
    bl_label = "Inside"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        hair = context.object
        layout = self.layout
        layout.column().prop(hair.libhair, "insides")
        layout.prop(hair.libhair, "insides_width")
        try:
            new = insides.missing(hair)
        except ValueError as error:
            layout.label(text=str(error), icon="ERROR")
            return
        if new:
            layout.label(text=f"Simulate again for {', '.join(new)}", icon="INFO")


class LIBHAIR_PT_grow(_Tab, bpy.types.Panel):
    bl_label = "Grow"

    def draw(self, _context):
        column = self.layout.column()
        column.operator("libhair.open_hair_mesh", icon="FILE_FOLDER")
        column.operator("libhair.grow", icon="OUTLINER_OB_CURVES")
        column.operator("libhair.to_curves", icon="CURVES_DATA")


_CLASSES = (LIBHAIR_PT_simulation, LIBHAIR_PT_shadow, LIBHAIR_PT_insides, LIBHAIR_PT_grow)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
