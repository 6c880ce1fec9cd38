"""Give a time to what is selected in Edit Mode."""

import bpy
import numpy as np

from .. import names
from ..core.errors import UsageError
from ..scene import constraints, mark_lists
from ..scene.attributes import read_attribute, write_attribute
from .mark_base import MarkOperator, time_property


class MESHKNIT_OT_assign_time(MarkOperator, bpy.types.Operator):
    """Give a time to the selection: its edges become a time constraint. Where times come from the
    attribute knit_time, its vertices get this time"""

    bl_idname = names.OP_ASSIGN_TIME
    bl_label = "Assign Knit Time"

    time: time_property("the selection is")

    def change(self, context, ob):
        if getattr(ob.data, names.PROPERTIES).time_source == "ATTRIBUTE":
            self._write_times(ob.data)
            return
        edges = constraints.selected_chain(ob.data)
        held = np.unique(constraints.constraint_marks(ob.data)[edges])
        whole = len(held) == 1 and held[0] > 0
        if whole and len(constraints.edges_of_constraint(ob.data, held[0] - 1)) == len(edges):
            mark_lists.set_time(ob.data, mark_lists.CONSTRAINTS, int(held[0]) - 1, self.time)
        else:
            constraints.add_constraint(ob.data, edges, self.time)

    def _write_times(self, mesh):
        chosen = constraints.selected_vertices(mesh)
        if not chosen.any():
            raise UsageError("Select the vertices that are knit at one time, in Edit Mode")
        times = read_attribute(mesh, names.TIME, "FLOAT", "POINT")
        times = np.zeros(len(chosen), np.float32) if times is None else times
        times[chosen] = self.time
        write_attribute(mesh, names.TIME, "FLOAT", "POINT", times)


CLASSES = (MESHKNIT_OT_assign_time,)
