"""Make a round opening with the mouse."""

import bpy
import numpy as np
from bpy.props import FloatVectorProperty
from mathutils import Vector

from .. import names
from ..overlay import stroke
from ..scene import mark_lists, openings
from ..scene.opening_rings import ring_on_surface, surface_of
from ..scene.read_model import mean_scale, millimetres_of_radius
from .mark_base import MarkOperator, radius_property, time_property
from .stroke_base import StrokeOperator, new_time


class MESHKNIT_OT_drag_opening(StrokeOperator, MarkOperator, bpy.types.Operator):
    """Drag out a round opening from the place under the mouse"""

    bl_idname = names.OP_DRAG_OPENING
    bl_label = "Drag Opening"
    confirm = ("LEFTMOUSE", "PRESS")
    keys = "Move: radius   Click or Enter: make it   Esc: leave"

    time: time_property("the rim is")
    radius: radius_property("SKIP_SAVE")
    location: FloatVectorProperty(
        name="Location", description="A place on the surface, in world space", size=3
    )

    def change(self, context, ob):
        local = ob.matrix_world.inverted_safe() @ Vector(self.location)
        radius = self.radius / millimetres_of_radius(context.scene, ob)
        openings.add_opening(ob.data, local, radius, self.time)
        mark_lists.OPENINGS.select(ob.data, len(mark_lists.OPENINGS.entries(ob.data)) - 1)

    def begin(self, context, event, ob, canvas, pointer):
        hit = pointer.hit()
        if hit is None:
            self.report({"WARNING"}, "Point at the surface: the opening's middle is there")
            return {"CANCELLED"}
        self.location = hit.place
        self.time = new_time(context, ob)
        self._reach = 0.0
        self._millimetres = millimetres_of_radius(context.scene, ob) / mean_scale(ob.matrix_world)
        return None

    def follow(self, context, event, ob, canvas, pointer):
        hit = pointer.hit()
        place = pointer.on_plane_through(self.location) if hit is None else hit.place
        self._reach = float(np.linalg.norm(place - np.array(self.location)))
        depsgraph = context.view_layer.depsgraph
        surface = canvas.surface(lambda: surface_of(ob, depsgraph))
        ring = ring_on_surface(surface, ob.matrix_world, self.location, self._reach)
        if ring is not None:
            stroke.show(stroke.Stroke(np.vstack([ring, ring[:1]]), None))

    def text(self):
        return f"Opening of {self._reach * self._millimetres:.1f} mm radius at time {self.time:.3g}"

    def finish(self, context):
        if self._reach <= 0.0:
            return {"CANCELLED"}
        self.radius = self._reach * self._millimetres
        return self.execute(context)


CLASSES = (MESHKNIT_OT_drag_opening,)
