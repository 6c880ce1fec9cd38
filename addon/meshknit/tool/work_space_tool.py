"""The tool as Blender's toolbar knows it: once for each mode that it works in."""

import bpy

from .. import names
from ..scene.mark_lists import selected_mark
from . import icon
from .keys import KEYMAP

MODES = ("OBJECT", "EDIT_MESH")


class KnitTimeTool:
    bl_space_type = "VIEW_3D"
    bl_idname = names.TOOL
    bl_label = "Knit Time"
    bl_description = (
        "Say when parts of the surface are knit: drag to lay a time constraint along its edges, "
        "click to select one.\n+ and - change its time, C takes a whole boundary, R drags out an "
        "opening, X deletes"
    )
    bl_icon = str(icon.FILE)
    bl_cursor = "DEFAULT"
    bl_keymap = KEYMAP

    def draw_settings(context, layout, tool):
        scene = getattr(context.scene, names.PROPERTIES)
        layout.prop(scene, "new_time_from")
        if scene.new_time_from == "VALUE":
            layout.prop(scene, "new_time")
        ob = context.object
        found = selected_mark(ob.data) if ob is not None and ob.type == "MESH" else None
        if found is None:
            return
        marks, index = found
        entry = marks.entries(ob.data)[index]
        layout.separator()
        layout.label(text=entry.name)
        if marks.kind == "OPENING" and not entry.has_time:
            layout.prop(entry, "has_time")
        else:
            layout.prop(entry, "time")
        if marks.kind == "OPENING" and entry.number == 0:
            wide = layout.row()
            wide.ui_units_x = 8  # as wide as others, the name would be cut off
            wide.prop(entry, "radius")
        layout.operator(names.OP_REMOVE_MARK, text="", icon="X")


TOOLS = tuple(
    type(
        f"MESHKNIT_WT_{mode.lower()}",
        (KnitTimeTool, bpy.types.WorkSpaceTool),
        {"bl_context_mode": mode, "__doc__": KnitTimeTool.bl_description},
    )
    for mode in MODES
)


_registered = []


def register():
    # A Blender without windows has no keys yet when it switches on what the preferences say.
    if bpy.context.window_manager.keyconfigs.addon is None:
        return
    for tool in TOOLS:
        bpy.utils.register_tool(tool, after={"builtin.measure"}, separator=True)
        _registered.append(tool)


def unregister():
    while _registered:
        bpy.utils.unregister_tool(_registered.pop())
