"""Select a mark, give it another time, remove it: what the tool's click and keys do."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from .. import names
from ..core.errors import UsageError
from ..scene import mark_lists
from ..scene.edit_mode import active_mesh
from .mark_base import MarkOperator

NO_MARKS = "There is no constraint or opening yet"


def selected(mesh):
    """-> (list, index). Throws UsageError."""
    found = mark_lists.selected_mark(mesh)
    if found is None:
        raise UsageError(NO_MARKS)
    return found


def pick(kind, index):
    """Selects a mark as an undo step of its own, from within another operator, of which Blender
    would make none."""
    bpy.ops.meshknit.pick_mark(kind=kind, index=index)
    bpy.ops.ed.undo_push(message="Pick Constraint or Opening")


class KeyOperator(MarkOperator):
    """Mixin for what keys do: without a mark they say so in the status bar, not in a popup."""

    def invoke(self, context, event):
        if mark_lists.selected_mark(active_mesh(context).data) is None:
            self.report({"WARNING"}, NO_MARKS)
            return {"CANCELLED"}
        return self.execute(context)


class MESHKNIT_OT_pick_mark(MarkOperator, bpy.types.Operator):
    """Make a constraint or an opening the one that keys act on"""

    bl_idname = names.OP_PICK_MARK
    bl_label = "Pick Constraint or Opening"

    kind: EnumProperty(name="Kind", items=names.MARK_KINDS)
    index: IntProperty(name="Index", min=0)

    def change(self, context, ob):
        marks = next(marks for marks in mark_lists.ALL if marks.kind == self.kind)
        if marks.index_of(ob.data, self.index) is None:
            raise UsageError(f"There is no {marks.noun} {self.index}")
        marks.select(ob.data, self.index)


class MESHKNIT_OT_change_time(KeyOperator, bpy.types.Operator):
    """Knit the selected constraint or opening earlier or later"""

    bl_idname = names.OP_CHANGE_TIME
    bl_label = "Change Knit Time"

    delta: FloatProperty(name="By", default=0.1, min=-2.0, max=2.0, step=1)

    def change(self, context, ob):
        marks, index = selected(ob.data)
        entry = marks.entries(ob.data)[index]
        mark_lists.set_time(ob.data, marks, index, entry.time + self.delta)
        self.report({"INFO"}, f"{entry.name}: time {entry.time:.3g}")


class MESHKNIT_OT_remove_mark(KeyOperator, bpy.types.Operator):
    """Remove the selected constraint or opening; the mesh stays as it is"""

    bl_idname = names.OP_REMOVE_MARK
    bl_label = "Remove Constraint or Opening"

    def change(self, context, ob):
        marks, index = selected(ob.data)
        marks.remove(ob.data, index)


CLASSES = (MESHKNIT_OT_pick_mark, MESHKNIT_OT_change_time, MESHKNIT_OT_remove_mark)
