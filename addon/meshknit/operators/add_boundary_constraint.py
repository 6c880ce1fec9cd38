"""Give a time to a boundary."""

import bpy
import numpy as np
from bpy.props import FloatProperty

from .. import names
from ..scene import constraints, sessions
from ..scene.edit_mode import active_mesh, object_mode
from .stage_base import poll_mesh


class MESHKNIT_OT_add_boundary_constraint(bpy.types.Operator):
    """Give a time to a boundary: in Edit Mode to those with selected vertices, else to the next
    boundary that has none"""

    bl_idname = names.OP_ADD_BOUNDARY
    bl_label = "Add from Boundary"
    bl_options = {"REGISTER", "UNDO"}

    time: FloatProperty(
        name="Time",
        description="When the boundary is knit: -1 is first, 1 is last",
        min=-1.0,
        max=1.0,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        editing = ob.mode == "EDIT"
        with object_mode(ob):
            mesh = ob.data
            loops = constraints.loops_without_constraint(mesh)
            if not loops:
                self.report({"WARNING"}, "Every boundary has a time already, or there is none")
                return {"CANCELLED"}
            if editing:
                chosen = constraints.selected_vertices(mesh)
                edges = constraints.edge_vertices(mesh)
                loops = [loop for loop in loops if chosen[edges[loop]].any()]
                if not loops:
                    self.report({"WARNING"}, "Select a vertex of a boundary that has no time yet")
                    return {"CANCELLED"}
            if not self.properties.is_property_set("time"):
                self.time = constraints.suggested_time(mesh)
            edges = np.concatenate(loops) if editing else loops[0]
            number = len(getattr(mesh, names.PROPERTIES).constraints) + 1
            constraints.add_constraint(mesh, edges, self.time, f"Boundary {number}")
        sessions.touch(ob)
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_add_boundary_constraint,)
