"""The sidebar's Knit tab: size and gauge, constraints, steps."""

import bpy

from .. import compat, names, native
from ..scene import sessions
from ..scene.mark_lists import CONSTRAINTS
from .text import draw_text, draw_value


class KnitPanel:
    """Mixin: a panel of the tab."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = names.SIDEBAR


class KnitSubPanel(KnitPanel):
    """Mixin: a panel about the active mesh, below the first."""

    bl_parent_id = names.PANEL

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"


class MESHKNIT_PT_knit(KnitPanel, bpy.types.Panel):
    bl_idname = names.PANEL
    bl_label = "Knit"

    def draw(self, context):
        layout = self.layout
        missing = native.why_missing()
        if missing:
            draw_text(layout.box(), context, missing, "ERROR")
            return
        if not KnitSubPanel.poll(context):
            draw_text(layout, context, "Choose a mesh object, or add one:")
            layout.menu(names.MENU_SHAPES, text="Add a Knit Shape", icon="MATCLOTH")
            return
        column = layout.column(align=True)
        column.scale_y = 1.2
        column.operator(names.OP_CHECK, icon="CHECKMARK")
        column.operator(names.OP_SOLVE_TIME, icon="TIME")
        column.operator(names.OP_BUILD_GRAPH, icon="MESH_GRID")
        column.operator(names.OP_SCHEDULE, icon="MOD_ARRAY")
        column.operator(names.OP_WRITE, icon="EXPORT")
        # Below the steps: nothing slides under the mouse that has just clicked one.
        job = sessions.job()
        if job is not None:
            compat.draw_progress(layout, job.progress, "Working")
            layout.operator(names.OP_CANCEL, icon="CANCEL")
        layout.label(text="Machine file:")
        layout.prop(getattr(context.scene, names.PROPERTIES), "output", text="")


def draw_marks(layout, mesh, marks, list_id):
    """A list of marks, of which one is active. -> the column beside it, for buttons"""
    row = layout.row()
    row.template_list(list_id, "", mesh, marks.entries_name, mesh, marks.active_name, rows=3)
    return row.column(align=True)


def shown_scale(context):
    """Millimetres that a Blender unit of the active object becomes."""
    mesh = getattr(context.object.data, names.PROPERTIES)
    if mesh.size_mode == "SCALE":
        return mesh.scale
    longest = max(context.object.dimensions)
    if mesh.size_mode == "SIZE" and longest > 0.0:
        return mesh.size / longest
    return 1000.0 * context.scene.unit_settings.scale_length


class MESHKNIT_PT_setup(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_setup"
    bl_label = "Size and Gauge"

    def draw(self, context):
        layout = self.layout
        scene = getattr(context.scene, names.PROPERTIES)
        mesh = getattr(context.object.data, names.PROPERTIES)
        row = layout.split(factor=0.4)
        row.label(text="Size from")
        row.prop(mesh, "size_mode", text="")
        longest = max(context.object.dimensions)
        if mesh.size_mode == "SIZE":
            layout.label(text="Longest side, in mm:")
            layout.prop(mesh, "size", text="")
        elif mesh.size_mode == "SCALE":
            layout.label(text="mm per unit:")
            layout.prop(mesh, "scale", text="")
        scale = shown_scale(context)
        if mesh.size_mode != "SCALE" and longest > 0.0:
            draw_value(layout, "mm per unit", f"{scale:.4g}")
        if mesh.size_mode != "SIZE":
            draw_value(layout, "Longest", f"{longest * scale:.0f} mm")
        layout.label(text="One stitch, in mm:")
        column = layout.column(align=True)
        column.prop(scene, "stitch_width", text="Width")
        column.prop(scene, "stitch_height", text="Height")
        layout.prop(scene, "relax")
        layout.prop(scene, "allow_seams")
        layout.prop(scene, "machine", text="")
        layout.label(text="Profile of your own:")
        layout.prop(scene, "machine_file", text="")


class MESHKNIT_UL_constraints(bpy.types.UIList):
    bl_idname = names.LIST_CONSTRAINTS

    def draw_item(self, context, layout, data, item, icon, active_data, active_name):
        row = layout.split(factor=0.62, align=True)
        row.prop(item, "name", text="", emboss=False)
        row.prop(item, "time", text="")


class MESHKNIT_PT_constraints(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_constraints"
    bl_label = "Time"

    def draw(self, context):
        layout = self.layout
        mesh = getattr(context.object.data, names.PROPERTIES)
        layout.prop(mesh, "time_source", text="")
        if mesh.time_source == "ATTRIBUTE":
            return
        self._draw_source(context, mesh)
        beside = draw_marks(layout, mesh, CONSTRAINTS, names.LIST_CONSTRAINTS)
        beside.operator(names.OP_REMOVE_CONSTRAINT, text="", icon="REMOVE").index = -1
        beside.operator(names.OP_SELECT_CONSTRAINT, text="", icon="RESTRICT_SELECT_OFF").index = -1
        column = layout.column(align=True)
        column.operator(names.OP_ADD_BOUNDARY, icon="ADD")
        column.operator(names.OP_FROM_SEAMS, icon="ADD")
        if context.object.mode == "EDIT":
            column.operator(names.OP_ADD_CONSTRAINT, icon="ADD")
        else:
            column.label(text="More in Edit Mode")

    def _draw_source(self, context, mesh):
        """What a source other than the constraints needs to know."""
        if mesh.time_source == "CONSTRAINTS":
            return
        column = self.layout.column(align=True)
        if mesh.time_source == "HEIGHT":
            column.prop(mesh, "time_axis", text="Along")
        elif mesh.time_source == "VALUES":
            column.prop(mesh, "time_values", text="", icon="SPREADSHEET")
        column.prop(mesh, "time_share", slider=True)
        column.prop(mesh, "time_mend")


CLASSES = (
    MESHKNIT_PT_knit,
    MESHKNIT_PT_setup,
    MESHKNIT_UL_constraints,
    MESHKNIT_PT_constraints,
)
