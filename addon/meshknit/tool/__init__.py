"""The workspace tool "Knit Time": what its keys do, and what it shows under the mouse."""

import bpy

from . import hover, menus, status, work_space_tool


def register():
    work_space_tool.register()
    menus.register()
    if not bpy.app.background:
        hover.register()
        status.register()


def unregister():
    if not bpy.app.background:
        status.unregister()
        hover.unregister()
    menus.unregister()
    work_space_tool.unregister()
