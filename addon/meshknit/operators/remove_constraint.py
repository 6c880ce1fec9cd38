"""Remove a time constraint."""

import bpy
from bpy.props import IntProperty

from .. import names
from ..scene import constraints, sessions
from ..scene.edit_mode import active_mesh, object_mode
from .stage_base import poll_mesh


class MESHKNIT_OT_remove_constraint(bpy.types.Operator):
    """Remove a time constraint; the mesh stays as it is"""

    bl_idname = names.OP_REMOVE_CONSTRAINT
    bl_label = "Remove Constraint"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(name="Index", default=-1, description="-1 is the active one")

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        return len(getattr(active_mesh(context).data, names.PROPERTIES).constraints) > 0

    def execute(self, context):
        ob = active_mesh(context)
        settings = getattr(ob.data, names.PROPERTIES)
        index = settings.active if self.index < 0 else self.index
        if index >= len(settings.constraints):
            self.report({"ERROR"}, f"There is no constraint {index}")
            return {"CANCELLED"}
        with object_mode(ob):
            constraints.remove_constraint(ob.data, index)
        sessions.touch(ob)
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_remove_constraint,)
