"""Add > Mesh > Knit."""

import bpy

from .. import names


class MESHKNIT_MT_shapes(bpy.types.Menu):
    bl_idname = names.MENU_SHAPES
    bl_label = "Knit"

    def draw(self, context):
        layout = self.layout
        layout.operator(names.OP_ADD_TUBE, icon="MESH_CYLINDER")
        layout.operator(names.OP_ADD_CONE, icon="MESH_CONE")
        layout.operator(names.OP_ADD_BENT_TUBE, icon="MOD_SIMPLEDEFORM")
        layout.separator()
        layout.operator(names.OP_ADD_TWO_WAY_SPLIT, icon="SORT_DESC")
        layout.operator(names.OP_ADD_THREE_WAY_SPLIT, icon="SORT_DESC")
        layout.operator(names.OP_ADD_TWO_WAY_MERGE, icon="SORT_ASC")
        layout.operator(names.OP_ADD_THREE_WAY_MERGE, icon="SORT_ASC")
        layout.operator(names.OP_ADD_RING_TORUS, icon="MESH_TORUS")
        layout.separator()
        layout.operator(names.OP_ADD_SOCK, icon="MATCLOTH")
        layout.operator(names.OP_ADD_TROUSERS, icon="MATCLOTH")
        layout.operator(names.OP_ADD_MITTEN, icon="MATCLOTH")
        layout.operator(names.OP_ADD_TEDDY, icon="MATCLOTH")


def draw_entry(self, context):
    self.layout.menu(names.MENU_SHAPES, icon="MATCLOTH")


CLASSES = (MESHKNIT_MT_shapes,)
