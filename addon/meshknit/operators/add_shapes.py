"""Add > Mesh > Knit: shapes that are ready to knit. Lengths in millimetres."""

import math

import bpy
from bpy.props import FloatProperty

from .. import names, native
from ..scene.shapes import add_shape


class ShapeOperator:
    """Mixin. Subclasses make the shape in the library."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if context.mode != "OBJECT":
            cls.poll_message_set("Go to Object Mode first")
            return False
        return True

    def execute(self, context):
        try:
            shape = self.make(native.load())
        except native.NativeMissing as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        add_shape(context, self.bl_label, shape, context.scene.cursor.location)
        return {"FINISHED"}


def _length(name, default):
    return FloatProperty(name=f"{name} (mm)", default=default, min=1.0, soft_max=500.0, precision=1)


class MESHKNIT_OT_add_straight_tube(ShapeOperator, bpy.types.Operator):
    """Add an upright tube"""

    bl_idname = names.OP_ADD_TUBE
    bl_label = "Straight Tube"

    radius: _length("Radius", 30.0)
    length: _length("Length", 120.0)

    def make(self, library):
        return library.straight_tube(self.radius, self.length)


class MESHKNIT_OT_add_cone(ShapeOperator, bpy.types.Operator):
    """Add an upright truncated cone, open at both ends"""

    bl_idname = names.OP_ADD_CONE
    bl_label = "Cone"

    start_radius: _length("Start radius", 45.0)
    end_radius: _length("End radius", 20.0)
    height: _length("Height", 120.0)

    def make(self, library):
        return library.cone(self.start_radius, self.end_radius, self.height)


class MESHKNIT_OT_add_bent_tube(ShapeOperator, bpy.types.Operator):
    """Add a tube with a bend"""

    bl_idname = names.OP_ADD_BENT_TUBE
    bl_label = "Bent Tube"

    angle: FloatProperty(
        name="Angle",
        description="How far the tube bends",
        subtype="ANGLE",
        default=math.radians(90.0),
        min=0.0,
        max=math.radians(150.0),
    )
    radius: _length("Radius", 25.0)
    leg: _length("Length of each leg", 50.0)

    def make(self, library):
        return library.bent_tube(min(math.degrees(self.angle), 150.0), self.radius, self.leg)


class ExampleOperator(ShapeOperator):
    """Mixin for shapes of one size. Their operators are called after the library's names."""

    def make(self, library):
        return library.example_shape(self.bl_idname.rpartition("add_")[2])


EXAMPLES = (
    (names.OP_ADD_SOCK, "Sock", "a sock with a heel, open at cuff and toe"),
    (
        names.OP_ADD_TROUSERS,
        "Trousers",
        "trousers, knit from the waist down: one tube that splits into two legs",
    ),
    (names.OP_ADD_MITTEN, "Mitten", "a mitten, open at cuff, fingertips and thumb"),
    (
        names.OP_ADD_TEDDY,
        "Teddy",
        "a closed teddy bear with openings marked on feet, hands and ears",
    ),
    (
        names.OP_ADD_RING_TORUS,
        "Ring Torus",
        "an upright ring with a hole in its skin at the bottom and one at the top",
    ),
    (names.OP_ADD_TWO_WAY_SPLIT, "Two-Way Split", "a tube that splits into two"),
    (
        names.OP_ADD_THREE_WAY_SPLIT,
        "Three-Way Split",
        "a tube that splits into three side by side",
    ),
    (names.OP_ADD_TWO_WAY_MERGE, "Two-Way Merge", "two tubes that merge into one"),
    (
        names.OP_ADD_THREE_WAY_MERGE,
        "Three-Way Merge",
        "three tubes side by side that merge into one",
    ),
)


def _example(idname, label, what):
    content = {"__doc__": f"Add {what}", "bl_idname": idname, "bl_label": label}
    name = f"MESHKNIT_OT_{idname.partition('.')[2]}"
    return type(name, (ExampleOperator, bpy.types.Operator), content)


CLASSES = (
    MESHKNIT_OT_add_straight_tube,
    MESHKNIT_OT_add_cone,
    MESHKNIT_OT_add_bent_tube,
    *(_example(*example) for example in EXAMPLES),
)
