"""Select the edges of a time constraint."""

import bpy
from bpy.props import IntProperty

from .. import names
from ..core.errors import UsageError
from ..scene import constraints
from ..scene.edit_mode import active_mesh, object_mode
from ..scene.select_elements import select_elements
from .stage_base import poll_mesh


class MESHKNIT_OT_select_constraint(bpy.types.Operator):
    """Select the edges of a time constraint in Edit Mode"""

    bl_idname = names.OP_SELECT_CONSTRAINT
    bl_label = "Select Constraint"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(name="Index", default=-1, description="-1 is the active one")

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        settings = getattr(ob.data, names.PROPERTIES)
        index = settings.active if self.index < 0 else self.index
        try:
            with object_mode(ob):
                rows = constraints.edges_of_constraint(ob.data, index)
                edges = constraints.edge_vertices(ob.data)[rows].tolist()
            if not edges:
                self.report({"WARNING"}, "This constraint has no edges any more")
                return {"CANCELLED"}
            select_elements(context, ob, edges=edges)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_select_constraint,)
