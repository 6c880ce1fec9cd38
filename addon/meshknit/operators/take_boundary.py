"""Give a time to the boundary under the mouse."""

import bpy
import numpy as np
from bpy.props import IntProperty

from .. import names
from ..core.errors import UsageError
from ..scene import constraints, mark_lists
from .edit_mark import pick
from .mark_base import MarkOperator, time_property
from .stroke_base import new_time, pointer_at


class MESHKNIT_OT_take_boundary(MarkOperator, bpy.types.Operator):
    """Give a time to the whole boundary under the mouse"""

    bl_idname = names.OP_TAKE_BOUNDARY
    bl_label = "Take Boundary"

    time: time_property("the boundary is")
    vertex: IntProperty(name="Vertex", description="A vertex of the boundary", min=0)

    def change(self, context, ob):
        mesh = ob.data
        edges = constraints.edge_vertices(mesh)
        loops = [
            rim for rim in constraints.boundary_loops(mesh) if (edges[rim] == self.vertex).any()
        ]
        if not loops:
            raise UsageError(f"Vertex {self.vertex} is on no boundary")
        number = len(mark_lists.CONSTRAINTS.entries(mesh)) + 1
        constraints.add_constraint(mesh, loops[0], self.time, f"Boundary {number}")

    def invoke(self, context, event):
        found = pointer_at(context, event)
        edge = found[2].rim() if found else None
        if edge is None:
            self.report({"WARNING"}, "No boundary here: point at an open edge of the surface")
            return {"CANCELLED"}
        ob, canvas, _ = found
        marks = np.unique(canvas.marks[canvas.rim_of(edge)])
        if len(marks) == 1 and marks[0] > 0:
            pick("CONSTRAINT", int(marks[0]) - 1)
            self.report({"INFO"}, "This boundary has a time already")
            return {"CANCELLED"}
        self.vertex = int(canvas.edges[edge][0])
        self.time = new_time(context, ob)
        return self.execute(context)


CLASSES = (MESHKNIT_OT_take_boundary,)
