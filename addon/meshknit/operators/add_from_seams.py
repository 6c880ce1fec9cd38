"""Give a time to the seams that UV unwrapping uses."""

import bpy

from .. import names
from ..core.edge_chains import ordered_chain
from ..core.errors import UsageError
from ..scene import constraints
from .mark_base import MarkOperator, NothingToDo, time_property


class MESHKNIT_OT_add_from_seams(MarkOperator, bpy.types.Operator):
    """Make a time constraint of every UV seam that is one chain or loop of edges and has no time yet"""

    bl_idname = names.OP_FROM_SEAMS
    bl_label = "Add from UV Seams"

    time: time_property("these edges are")

    def change(self, context, ob):
        mesh = ob.data
        edges, marks = constraints.edge_vertices(mesh), constraints.constraint_marks(mesh)
        seams = constraints.seam_chains(mesh)
        if not seams:
            raise UsageError("The mesh has no UV seams: mark some in Edit Mode, Edge > Mark Seam")
        new = [seam for seam in seams if not marks[seam].any()]
        if not new:
            raise NothingToDo("Every UV seam has a time already")
        chains = [seam for seam in new if ordered_chain(edges, seam) is not None]
        if not chains:
            raise UsageError("The UV seams branch: clear all but one branch, Edge > Clear Seam")
        for seam in chains:
            constraints.add_constraint(mesh, seam, self.time)
        if len(chains) < len(new):
            self.report({"WARNING"}, f"{len(new) - len(chains)} UV seams branch and were left out")


CLASSES = (MESHKNIT_OT_add_from_seams,)
