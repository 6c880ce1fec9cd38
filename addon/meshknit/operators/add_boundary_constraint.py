"""Give a time to a boundary."""

import bpy
import numpy as np

from .. import names
from ..scene import constraints, mark_lists
from .mark_base import MarkOperator, NothingToDo, time_property


class MESHKNIT_OT_add_boundary_constraint(MarkOperator, bpy.types.Operator):
    """Give a time to a boundary: in Edit Mode to those with selected vertices, else to the next
    boundary that has none"""

    bl_idname = names.OP_ADD_BOUNDARY
    bl_label = "Add from Boundary"

    time: time_property("the boundary is")

    def change(self, context, ob):
        mesh = ob.data
        loops = constraints.loops_without_constraint(mesh)
        if not loops:
            raise NothingToDo("Every boundary has a time already, or there is none")
        if self.editing:
            chosen = constraints.selected_vertices(mesh)
            edges = constraints.edge_vertices(mesh)
            loops = [loop for loop in loops if chosen[edges[loop]].any()]
            if not loops:
                raise NothingToDo("Select a vertex of a boundary that has no time yet")
        if not self.properties.is_property_set("time"):
            self.time = mark_lists.suggested_time(mesh)
        edges = np.concatenate(loops) if self.editing else loops[0]
        number = len(mark_lists.CONSTRAINTS.entries(mesh)) + 1
        constraints.add_constraint(mesh, edges, self.time, f"Boundary {number}")


CLASSES = (MESHKNIT_OT_add_boundary_constraint,)
