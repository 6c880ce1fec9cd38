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
        return context.mode == "OBJECT"

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


class MESHKNIT_OT_add_sock(ShapeOperator, bpy.types.Operator):
    """Add a sock with a heel, open at cuff and toe"""

    bl_idname = names.OP_ADD_SOCK
    bl_label = "Sock"

    def make(self, library):
        return library.sock()


CLASSES = (
    MESHKNIT_OT_add_straight_tube,
    MESHKNIT_OT_add_cone,
    MESHKNIT_OT_add_bent_tube,
    MESHKNIT_OT_add_sock,
)
