"""Show a constraint or an opening in Edit Mode."""

import bpy
import numpy as np

from .. import names
from ..core.edge_chains import nearest_vertex
from ..core.errors import UsageError
from ..scene import constraints, mark_lists, openings, undo
from ..scene.attributes import positions
from ..scene.edit_mode import active_mesh, object_mode
from ..scene.select_elements import select_elements
from .mark_base import EntryOperator


class SelectOperator(EntryOperator):
    """Mixin. Subclasses have elements(mesh, index) -> arguments of select_elements()."""

    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        ob = active_mesh(context)
        try:
            index = self.entry_index(ob.data)
            with object_mode(ob):
                found = self.elements(ob.data, index)
            if not any(found.values()):
                text = f"This {self.marks.noun} has no part of the mesh any more"
                self.report({"WARNING"}, text)
                return {"CANCELLED"}
            select_elements(context, ob, **found)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.marks.select(ob.data, index)
        undo.keep_lists(ob)
        return {"FINISHED"}


class MESHKNIT_OT_select_constraint(SelectOperator, bpy.types.Operator):
    """Select the edges of a time constraint in Edit Mode"""

    bl_idname = names.OP_SELECT_CONSTRAINT
    bl_label = "Select Constraint"
    marks = mark_lists.CONSTRAINTS

    def elements(self, mesh, index):
        rows = constraints.edges_of_constraint(mesh, index)
        return {"edges": constraints.edge_vertices(mesh)[rows].tolist()}


class MESHKNIT_OT_select_opening(SelectOperator, bpy.types.Operator):
    """Select the faces of an opening in Edit Mode; of a round one the vertex nearest to its place"""

    bl_idname = names.OP_SELECT_OPENING
    bl_label = "Select Opening"
    marks = mark_lists.OPENINGS

    def elements(self, mesh, index):
        entry = self.marks.entries(mesh)[index]
        if entry.number:
            return {"faces": openings.faces_of_opening(mesh, index).tolist()}
        at = positions(mesh)
        return {"vertices": [nearest_vertex(at, np.array(entry.location))] if len(at) else []}


CLASSES = (MESHKNIT_OT_select_constraint, MESHKNIT_OT_select_opening)
