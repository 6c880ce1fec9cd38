"""Remove a constraint or an opening."""

import bpy

from .. import names
from ..scene import mark_lists
from .mark_base import EntryOperator, MarkOperator


class RemoveOperator(EntryOperator, MarkOperator):
    """Mixin."""

    def change(self, context, ob):
        self.marks.remove(ob.data, self.entry_index(ob.data))


class MESHKNIT_OT_remove_constraint(RemoveOperator, bpy.types.Operator):
    """Remove a time constraint; the mesh stays as it is"""

    bl_idname = names.OP_REMOVE_CONSTRAINT
    bl_label = "Remove Constraint"
    marks = mark_lists.CONSTRAINTS


class MESHKNIT_OT_remove_opening(RemoveOperator, bpy.types.Operator):
    """Remove an opening: its surface is knit again"""

    bl_idname = names.OP_REMOVE_OPENING
    bl_label = "Remove Opening"
    marks = mark_lists.OPENINGS


CLASSES = (MESHKNIT_OT_remove_constraint, MESHKNIT_OT_remove_opening)
