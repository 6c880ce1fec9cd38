"""Remove an opening."""

import bpy
from bpy.props import IntProperty

from .. import names
from ..scene import openings, sessions
from ..scene.edit_mode import active_mesh, object_mode
from .stage_base import poll_mesh


class MESHKNIT_OT_remove_opening(bpy.types.Operator):
    """Remove an opening: its surface is knit again"""

    bl_idname = names.OP_REMOVE_OPENING
    bl_label = "Remove Opening"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(name="Index", default=-1, description="-1 is the active one")

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        return len(getattr(active_mesh(context).data, names.PROPERTIES).openings) > 0

    def execute(self, context):
        ob = active_mesh(context)
        settings = getattr(ob.data, names.PROPERTIES)
        index = settings.active_opening if self.index < 0 else self.index
        if index >= len(settings.openings):
            self.report({"ERROR"}, f"There is no opening {index}")
            return {"CANCELLED"}
        with object_mode(ob):
            openings.remove_opening(ob.data, index)
        sessions.touch(ob)
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_remove_opening,)
