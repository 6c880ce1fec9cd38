"""The tool's keys in the status bar, while it is the active one."""

import bpy

from ..scene.active_tool import is_tool_active
from .keys import HELP


def _draw(self, context):
    if is_tool_active(context):
        row = self.layout.row(align=True)
        for icon, text in HELP:
            row.label(text=text, icon=icon)
        self.layout.separator_spacer()


def register():
    bpy.types.STATUSBAR_HT_header.prepend(_draw)


def unregister():
    bpy.types.STATUSBAR_HT_header.remove(_draw)
