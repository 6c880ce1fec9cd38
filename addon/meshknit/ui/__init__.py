"""Panels, lists and menus. They only show."""

import bpy

from . import panel, panel_guidance, panel_openings, panel_results, shapes_menu

CLASSES = (
    panel.CLASSES
    + panel_openings.CLASSES
    + panel_guidance.CLASSES
    + panel_results.CLASSES
    + shapes_menu.CLASSES
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_mesh_add.append(shapes_menu.draw_entry)


def unregister():
    bpy.types.VIEW3D_MT_mesh_add.remove(shapes_menu.draw_entry)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
