"""Mark a part of the surface as an opening."""

import bpy
from bpy.props import FloatVectorProperty
from mathutils import Vector

from .. import names
from ..core.errors import UsageError
from ..scene import mark_lists, openings
from ..scene.read_model import millimetres_of_radius
from .mark_base import MarkOperator, radius_property, time_property


class MESHKNIT_OT_add_opening(MarkOperator, bpy.types.Operator):
    """Leave a part of the surface open: in Edit Mode the selected faces, else a round opening at the
    3D cursor. Its rim is where knitting can start or end; the mesh stays whole"""

    bl_idname = names.OP_ADD_OPENING
    bl_label = "Add Opening"

    time: time_property("the rim is")
    radius: radius_property()
    location: FloatVectorProperty(
        name="Location",
        description="For scripts: a place on the surface, in world space, instead of the cursor or "
        "the selected faces",
        size=3,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def change(self, context, ob):
        placed = self.properties.is_property_set("location")
        by_faces = self.editing and not placed
        mesh = ob.data
        faces = openings.selected_faces(mesh)
        if by_faces and not len(faces):
            raise UsageError("Select the faces that are to be left open")
        if not self.properties.is_property_set("time"):
            self.time = mark_lists.suggested_time(mesh)
        if by_faces:
            openings.add_face_opening(mesh, faces, self.time)
        else:
            place = self.location if placed else context.scene.cursor.location
            local = ob.matrix_world.inverted_safe() @ Vector(place)
            radius = self.radius / millimetres_of_radius(context.scene, ob)
            openings.add_opening(mesh, local, radius, self.time)


CLASSES = (MESHKNIT_OT_add_opening,)
