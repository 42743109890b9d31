"""What is set for a head of hair, kept with its object in the .blend file."""

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

import libhair

from . import insides as _insides

_frame = libhair.FrameSettings()
_guides = libhair.GuideSettings()
_bind = libhair.BindSettings()
_fibre = libhair.Fibre()


class HairSettings(bpy.types.PropertyGroup):
    """Lengths and speeds are in the scene's units; defaults are libhair's."""

    # What moves the hair.
    head: PointerProperty(
        type=bpy.types.Object,
        name="Head",
        description="What the roots are on: a mesh, or the armature of the bone below. "
        "None: the hair's surface, else its parent",
    )
    bone: StringProperty(
        name="Bone", description="The bone that carries the hair, where the head is an armature"
    )
    collide_head: BoolProperty(
        name="Collide with Head",
        description="The head's mesh, as it is at the first frame, keeps hair out",
        default=True,
    )
    colliders: PointerProperty(
        type=bpy.types.Collection,
        name="Colliders",
        description="Meshes that keep hair out. They may move and turn, not change their shape",
    )
    body: PointerProperty(
        type=bpy.types.Object,
        name="Body",
        description="Armature whose deforming bones keep hair out, as capsules of their envelopes' "
        "radii; the bone that carries the hair is left out",
        poll=lambda _self, obj: obj.type == "ARMATURE",
    )
    detail: FloatProperty(
        name="Detail",
        description="Cells of the colliding meshes' distance fields; half of it takes eight times "
        "the memory",
        default=0.004,
        min=0.0005,
        soft_max=0.05,
        precision=4,
        unit="LENGTH",
    )

    # How it moves.
    guides: IntProperty(
        name="Guides",
        description="Strands that are simulated; all others follow them",
        default=_bind.guides,
        min=1,
        soft_max=5000,
    )
    points_per_guide: IntProperty(
        name="Points per Guide", default=_bind.points_per_guide, min=2, max=64
    )
    settle: FloatProperty(
        name="Settle",
        description="Seconds the hair gets to come to rest before the first frame",
        default=1.0,
        min=0.0,
        soft_max=10.0,
    )
    stiffness: FloatProperty(
        name="Stiffness",
        description="Resistance to bending, times that of libhair's default wisp; 0: a string",
        default=1.0,
        min=0.0,
        soft_max=10.0,
    )
    air_drag: FloatProperty(
        name="Air Drag",
        description="How fast motion through the air decays, 1/s",
        default=_guides.air_drag,
        min=0.0,
        soft_max=50.0,
    )
    friction: FloatProperty(
        name="Friction",
        description="Against colliders",
        default=_guides.friction,
        min=0.0,
        soft_max=1.0,
    )
    self_collision: BoolProperty(
        name="Self Collision",
        description="Hair keeps its volume",
        default=_frame.self_collision,
    )
    wind: FloatVectorProperty(
        name="Wind", description="Its velocity", default=(0, 0, 0), unit="VELOCITY"
    )
    gust: FloatProperty(
        name="Gust",
        description="Share of the wind that comes and goes",
        default=_frame.wind.gust,
        min=0.0,
        max=1.0,
    )
    cache_folder: StringProperty(
        name="Cache",
        description="Folder of the frames. None: libhair_cache beside the .blend file, or while it "
        "is not saved, a folder that goes when Blender does",
        subtype="DIR_PATH",
    )

    # What it consists of.
    hairs: FloatProperty(
        name="Hairs",
        description="Hairs that all strands stand for together",
        default=100_000,
        min=1,
        soft_max=300_000,
    )
    width: FloatProperty(
        name="Width of a Hair",
        default=_fibre.width,
        min=1e-7,
        soft_max=1e-3,
        precision=6,
        step=0.001,
        unit="LENGTH",
    )
    width_from_radius: BoolProperty(
        name="Width from Radius",
        description="A hair is as wide as twice the mean of the curves' radius attribute",
    )
    opacity: FloatProperty(
        name="Opacity",
        description="Share of light that a hair keeps from passing through it",
        default=_fibre.opacity,
        min=0.0,
        max=1.0,
    )

    # Shadow.
    footprint: FloatProperty(
        name="Footprint",
        description="Length over which shadows are averaged: the smallest that is seen of them",
        default=0.003,
        min=1e-4,
        soft_max=0.05,
        precision=4,
        unit="LENGTH",
    )
    shadow_follows: BoolProperty(
        name="At Every Frame",
        description="The shadow is computed anew whenever the frame changes",
    )
    shadow_on_head: BoolProperty(
        name="On the Head Too",
        description="The head's mesh gets the attribute as well, at its vertices",
    )

    # What is shown of the simulation's inside.
    insides: EnumProperty(
        name="Show",
        description="What is kept of every frame when the hair is simulated, and shown",
        items=_insides.ITEMS,
        options={"ENUM_FLAG"},
        update=_insides.on_change,
    )
    insides_width: FloatProperty(
        name="Line Width",
        default=0.0005,
        min=1e-6,
        soft_max=0.01,
        precision=4,
        unit="LENGTH",
        update=_insides.on_change,
    )

    # What the add-on keeps for itself.
    cache_path: StringProperty(options={"HIDDEN"})
    source: PointerProperty(type=bpy.types.Object, options={"HIDDEN"})
    insides_object: PointerProperty(type=bpy.types.Object, options={"HIDDEN"})
    message: StringProperty(options={"HIDDEN", "SKIP_SAVE"})


def copy(settings, to):
    """What a user sets, from one object's settings to another's."""
    for name in HairSettings.__annotations__:
        if name not in {"cache_path", "source", "insides_object", "message"}:
            setattr(to, name, getattr(settings, name))


def register():
    bpy.utils.register_class(HairSettings)
    bpy.types.Object.libhair = PointerProperty(type=HairSettings)


def unregister():
    del bpy.types.Object.libhair
    bpy.utils.unregister_class(HairSettings)
