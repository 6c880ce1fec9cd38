"""The tool's keys in the status bar, while it is the active one."""

import bpy

from ..scene.active_tool import is_tool_active
from .keys import HELP


_shown = {}  # window -> whether its bar shows the keys, as it was drawn last


def _draw(self, context):
    active = is_tool_active(context)
    _shown[context.window.as_pointer()] = active
    if active:
        row = self.layout.row(align=True)
        for icon, text in HELP:
            row.label(text=text, icon=icon)
        self.layout.separator_spacer()


def follow(context):
    """Has the bar drawn anew if another tool was in use when it was drawn. Blender itself does that
    when the mouse goes from region to region, but not after every change of tool."""
    if is_tool_active(context) != _shown.get(context.window.as_pointer(), False):
        context.workspace.status_text_set_internal(None)


def register():
    bpy.types.STATUSBAR_HT_header.prepend(_draw)


def unregister():
    bpy.types.STATUSBAR_HT_header.remove(_draw)
    _shown.clear()
