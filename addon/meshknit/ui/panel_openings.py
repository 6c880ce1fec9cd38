"""The sidebar's Knit tab: openings."""

import bpy

from .. import names
from .panel import KnitPanel


class MESHKNIT_UL_openings(bpy.types.UIList):
    bl_idname = names.LIST_OPENINGS

    def draw_item(self, context, layout, data, item, icon, active_data, active_name, index=0):
        row = layout.row(align=True)
        row.prop(item, "name", text="", emboss=False, icon="FACESEL" if item.number else "DOT")
        row.prop(item, "has_time", text="", icon="TIME")
        time = row.row(align=True)
        time.active = item.has_time
        time.prop(item, "time", text="")
        row.operator(
            names.OP_SELECT_OPENING, text="", icon="RESTRICT_SELECT_OFF", emboss=False
        ).index = index


class MESHKNIT_PT_openings(KnitPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_openings"
    bl_label = "Openings"
    bl_parent_id = names.PANEL

    def draw(self, context):
        layout = self.layout
        mesh = getattr(context.object.data, names.PROPERTIES)
        row = layout.row()
        row.template_list(names.LIST_OPENINGS, "", mesh, "openings", mesh, "active_opening", rows=3)
        row.operator(names.OP_REMOVE_OPENING, text="", icon="REMOVE").index = -1
        if 0 <= mesh.active_opening < len(mesh.openings):
            entry = mesh.openings[mesh.active_opening]
            if not entry.number:
                layout.prop(entry, "radius")
        editing = context.object.mode == "EDIT"
        text = "Add from Selected Faces" if editing else "Add at 3D Cursor"
        layout.operator(names.OP_ADD_OPENING, text=text, icon="ADD")


CLASSES = (MESHKNIT_UL_openings, MESHKNIT_PT_openings)
