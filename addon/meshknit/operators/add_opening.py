"""Mark a part of the surface as an opening."""

import bpy
import numpy as np
from bpy.props import FloatProperty, FloatVectorProperty
from mathutils import Vector

from .. import names
from ..scene import constraints, openings, sessions
from ..scene.attributes import positions
from ..scene.edit_mode import active_mesh, object_mode
from ..scene.read_model import mean_scale, millimetres_per_unit
from .stage_base import poll_mesh


class MESHKNIT_OT_add_opening(bpy.types.Operator):
    """Leave a part of the surface open: in Edit Mode the selected faces, else a round opening at the
    3D cursor. Its rim is where knitting can start or end; the mesh stays whole"""

    bl_idname = names.OP_ADD_OPENING
    bl_label = "Add Opening"
    bl_options = {"REGISTER", "UNDO"}

    time: FloatProperty(
        name="Time",
        description="When the rim is knit: -1 is first, 1 is last",
        min=-1.0,
        max=1.0,
        options={"SKIP_SAVE"},
    )
    radius: FloatProperty(
        name="Radius (mm)",
        description="How far a round opening reaches, measured along the surface",
        default=15.0,
        min=0.001,
        soft_max=200.0,
        precision=1,
    )
    location: FloatVectorProperty(
        name="Location",
        description="For scripts: a place on the surface, in world space, instead of the cursor or "
        "the selected faces",
        size=3,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        placed = self.properties.is_property_set("location")
        by_faces = ob.mode == "EDIT" and not placed
        with object_mode(ob):
            mesh = ob.data
            faces = openings.selected_faces(mesh)
            if by_faces and not len(faces):
                self.report({"ERROR"}, "Select the faces that are to be left open")
                return {"CANCELLED"}
            if not self.properties.is_property_set("time"):
                self.time = constraints.suggested_time(mesh)
            if by_faces:
                openings.add_face_opening(mesh, faces, self.time)
            else:
                place = self.location if placed else context.scene.cursor.location
                local = ob.matrix_world.inverted_safe() @ Vector(place)
                openings.add_opening(mesh, local, self._local_radius(context, ob), self.time)
        sessions.touch(ob)
        return {"FINISHED"}

    def _local_radius(self, context, ob):
        """In the object's own units, so that the opening grows with the object."""
        scale = millimetres_per_unit(ob, positions(ob.data), context.scene)
        longer = mean_scale(np.array(ob.matrix_world))
        return self.radius / (scale * longer) if longer > 0.0 else self.radius / scale


CLASSES = (MESHKNIT_OT_add_opening,)
