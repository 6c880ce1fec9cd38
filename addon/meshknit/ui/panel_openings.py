"""The sidebar's Knit tab: openings."""

import bpy

from .. import names
from ..scene.mark_lists import OPENINGS
from ..scene.read_model import mean_scale
from .panel import KnitSubPanel, draw_marks, shown_scale
from .text import draw_value


class MESHKNIT_UL_openings(bpy.types.UIList):
    bl_idname = names.LIST_OPENINGS

    def draw_item(self, context, layout, data, item, icon, active_data, active_name):
        row = layout.split(factor=0.55, align=True)
        row.prop(item, "name", text="", emboss=False)
        if item.has_time:
            row.prop(item, "time", text="")
        else:
            row.label(text="no time")


class MESHKNIT_PT_openings(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_openings"
    bl_label = "Openings"

    def draw(self, context):
        layout = self.layout
        mesh = getattr(context.object.data, names.PROPERTIES)
        beside = draw_marks(layout, mesh, OPENINGS, names.LIST_OPENINGS)
        beside.operator(names.OP_REMOVE_OPENING, text="", icon="REMOVE").index = -1
        beside.operator(names.OP_SELECT_OPENING, text="", icon="RESTRICT_SELECT_OFF").index = -1
        if 0 <= mesh.active_opening < len(mesh.openings):
            self._draw_entry(context, mesh.openings[mesh.active_opening])
        editing = context.object.mode == "EDIT"
        text = "Add from Selected Faces" if editing else "Add at 3D Cursor"
        layout.operator(names.OP_ADD_OPENING, text=text, icon="ADD")

    def _draw_entry(self, context, entry):
        layout = self.layout
        layout.prop(entry, "has_time")
        if entry.number == 0:
            layout.prop(entry, "radius")
            longer = mean_scale(context.object.matrix_world) * shown_scale(context)
            draw_value(layout, "Knitted", f"{entry.radius * longer:.1f} mm")


CLASSES = (MESHKNIT_UL_openings, MESHKNIT_PT_openings)
