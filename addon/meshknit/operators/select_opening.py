"""Show an opening."""

import bpy
import numpy as np
from bpy.props import IntProperty

from .. import names
from ..core.edge_chains import nearest_vertex
from ..core.errors import UsageError
from ..scene import openings
from ..scene.attributes import positions
from ..scene.edit_mode import active_mesh, object_mode
from ..scene.select_elements import select_elements
from .stage_base import poll_mesh


class MESHKNIT_OT_select_opening(bpy.types.Operator):
    """Select the faces of an opening in Edit Mode; of a round one the vertex nearest to its place"""

    bl_idname = names.OP_SELECT_OPENING
    bl_label = "Select Opening"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(name="Index", default=-1, description="-1 is the active one")

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        return len(getattr(active_mesh(context).data, names.PROPERTIES).openings) > 0

    def execute(self, context):
        ob = active_mesh(context)
        settings = getattr(ob.data, names.PROPERTIES)
        index = settings.active_opening if self.index < 0 else self.index
        if index >= len(settings.openings):
            self.report({"ERROR"}, f"There is no opening {index}")
            return {"CANCELLED"}
        entry = settings.openings[index]
        try:
            with object_mode(ob):
                faces = openings.faces_of_opening(ob.data, index).tolist()
                at = positions(ob.data)
            if entry.number and not faces:
                self.report({"WARNING"}, "This opening has no faces any more")
                return {"CANCELLED"}
            vertices = [] if entry.number else [nearest_vertex(at, np.array(entry.location))]
            select_elements(context, ob, vertices=vertices, faces=faces)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_select_opening,)
