"""The tool's work in Edit Mode's own menus, for those who select first."""

import bpy

from .. import names


def _draw_edges(self, context):
    self.layout.separator()
    self.layout.operator(names.OP_ASSIGN_TIME)
    self.layout.operator(names.OP_FROM_SEAMS, text="Knit Time from UV Seams")


def _draw_faces(self, context):
    self.layout.separator()
    self.layout.operator(names.OP_ADD_OPENING, text="Mark as Knit Opening")


def _draw_context_menu(self, context):
    _, edges, faces = context.tool_settings.mesh_select_mode
    if faces:
        _draw_faces(self, context)
    elif edges:
        _draw_edges(self, context)


ENTRIES = (
    ("VIEW3D_MT_edit_mesh_edges", _draw_edges),
    ("VIEW3D_MT_edit_mesh_faces", _draw_faces),
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_context_menu),
)


def register():
    for menu, draw in ENTRIES:
        getattr(bpy.types, menu).append(draw)


def unregister():
    for menu, draw in ENTRIES:
        getattr(bpy.types, menu).remove(draw)
