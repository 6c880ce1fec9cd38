"""What is stored in the scene (gauge, machine, display) and on a mesh (constraints, openings, size)."""

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import names
from .core.settings import Settings
from .scene import sessions, undo
from .scene.edit_mode import active_mesh

DEFAULTS = Settings()


def _touched(self, context):
    _note(self.id_data, context, sessions.ALL)


def _time_touched(self, context):
    _note(self.id_data, context, sessions.TIMES)


def _note(data, context, what):
    sessions.touch_users(data, context, what)
    if isinstance(data, bpy.types.Mesh):
        undo.keep_lists(active_mesh(context))


def _shown(_, context):
    sessions.redraw(context)


def time_property(when, **more):
    """When something is knit; `when` says so in words."""
    return FloatProperty(
        name="Time",
        description=f"{when}: -1 is first, 1 is last",
        min=-1.0,
        max=1.0,
        step=10,
        precision=3,
        **more,
    )


class MESHKNIT_PG_constraint(bpy.types.PropertyGroup):
    """An entry of the constraint list. Its edges are those whose knit_constraint names it."""

    time: time_property("When these edges are knit", update=_time_touched)


class MESHKNIT_PG_opening(bpy.types.PropertyGroup):
    """An entry of the list of openings: the faces whose knit_opening is its number, or, with the
    number 0, the surface within a radius of a place. Lengths are those of the object's own space,
    so the opening grows with the object."""

    number: IntProperty(name="Number", min=0, options={"HIDDEN"}, update=_touched)
    location: FloatVectorProperty(
        name="Place",
        description="A point on or near the surface, in the object's own space",
        subtype="TRANSLATION",
        size=3,
        update=_touched,
    )
    radius: FloatProperty(
        name="Radius",
        description="How far the opening reaches, measured along the surface",
        subtype="DISTANCE",
        default=0.01,
        min=0.0,
        precision=4,
        update=_touched,
    )
    has_time: BoolProperty(
        name="Knit at a time",
        description="The rim is knit at the time beside this; off: a constraint says when",
        default=True,
        update=_touched,
    )
    time: time_property("When the rim is knit", update=_time_touched)


class MESHKNIT_PG_mesh(bpy.types.PropertyGroup):
    constraints: CollectionProperty(type=MESHKNIT_PG_constraint)
    active: IntProperty(
        name="Active constraint",
        options={"HIDDEN"},
        update=lambda self, _: setattr(self, "selected_kind", "CONSTRAINT"),
    )
    openings: CollectionProperty(type=MESHKNIT_PG_opening)
    active_opening: IntProperty(
        name="Active opening",
        options={"HIDDEN"},
        update=lambda self, _: setattr(self, "selected_kind", "OPENING"),
    )
    selected_kind: EnumProperty(
        name="Keys act on", items=names.MARK_KINDS, options={"HIDDEN"}, update=_shown
    )
    time_source: EnumProperty(
        name="Time from",
        description="Where the knitting time of each vertex comes from",
        items=names.TIME_SOURCES,
        update=_touched,
    )
    time_axis: EnumProperty(
        name="Axis",
        description="The way the rows go",
        items=names.TIME_AXES,
        default="Z",
        update=_touched,
    )
    time_values: StringProperty(
        name="Values",
        description="A point attribute of numbers, or a vertex group: low is knit first",
        update=_touched,
    )
    time_share: FloatProperty(
        name="Share",
        description="How much of this source; the rest is interpolated between the constraints",
        subtype="FACTOR",
        default=1.0,
        min=0.0,
        max=1.0,
        update=_touched,
    )
    time_mend: BoolProperty(
        name="Mend",
        description="Remove places away from the openings where knitting would begin or end, with "
        "the smallest change",
        default=True,
        update=_touched,
    )
    size_mode: EnumProperty(
        name="Size from",
        description="How large the knitted object becomes",
        items=names.SIZE_MODES,
        update=_touched,
    )
    scale: FloatProperty(
        name="mm per unit",
        description="Millimetres that one Blender unit becomes",
        default=1000.0,
        min=1e-6,
        soft_max=10000.0,
        precision=3,
        update=_touched,
    )
    size: FloatProperty(
        name="Longest side (mm)",
        description="Length of the finished object's longest side, in millimetres",
        default=300.0,
        min=1e-3,
        soft_max=2000.0,
        precision=1,
        update=_touched,
    )


class MESHKNIT_PG_scene(bpy.types.PropertyGroup):
    stitch_width: FloatProperty(
        name="Stitch width (mm)",
        description="Distance between two wales of the relaxed fabric",
        default=DEFAULTS.stitch_width,
        min=0.1,
        soft_max=20.0,
        precision=2,
        update=_touched,
    )
    stitch_height: FloatProperty(
        name="Stitch height (mm)",
        description="Distance between two courses of the relaxed fabric",
        default=DEFAULTS.stitch_height,
        min=0.1,
        soft_max=20.0,
        precision=2,
        update=_touched,
    )
    relax: BoolProperty(
        name="Even out stitches",
        description="Move stitches along the surface, and add some where they stretch, for even sizes",
        default=DEFAULTS.relax,
        update=_touched,
    )
    machine: EnumProperty(
        name="Machine",
        description="The machine that the program is for",
        items=names.MACHINES,
        update=_touched,
    )
    machine_file: StringProperty(
        name="Profile file",
        description="A JSON file with a machine of your own, used instead of the one above",
        subtype="FILE_PATH",
        update=_touched,
    )
    allow_seams: BoolProperty(
        name="Allow seams to sew",
        description="Where tubes would have to cross on the machine, knit the object in parts that "
        "are sewn together afterwards",
        default=DEFAULTS.allow_seams,
        update=_touched,
    )
    output: StringProperty(
        name="Machine file",
        description="Where Write puts the knitout program. Left empty: a file named after the "
        "object, beside the .blend file or in your documents",
        default="",
        subtype="FILE_PATH",
    )
    new_time_from: EnumProperty(
        name="New marks",
        description="Which time a mark gets that is made with the Knit Time tool",
        items=names.NEW_TIMES,
    )
    new_time: time_property("The time of new marks")
    live_graph: BoolProperty(
        name="Live graph",
        description="Build the knit graph in the background whenever nothing has changed for a moment",
        default=True,
        update=_touched,
    )
    show_time: BoolProperty(
        name="Time colours",
        description="Show the time field: blue is knit early, red late",
        default=True,
        update=_shown,
    )
    show_graph: BoolProperty(
        name="Knit graph",
        description="Show rows and columns, short rows, increases and decreases",
        default=True,
        update=_shown,
    )


CLASSES = (MESHKNIT_PG_constraint, MESHKNIT_PG_opening, MESHKNIT_PG_mesh, MESHKNIT_PG_scene)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    setattr(bpy.types.Mesh, names.PROPERTIES, PointerProperty(type=MESHKNIT_PG_mesh))
    setattr(bpy.types.Scene, names.PROPERTIES, PointerProperty(type=MESHKNIT_PG_scene))


def unregister():
    delattr(bpy.types.Scene, names.PROPERTIES)
    delattr(bpy.types.Mesh, names.PROPERTIES)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
