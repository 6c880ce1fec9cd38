"""Give a time to a boundary that the guidance names."""

import bpy
from bpy.props import IntProperty
from mathutils import Vector

from .. import names
from ..core.errors import UsageError
from ..scene import constraints, mark_lists, sessions
from .mark_base import MarkOperator


class MESHKNIT_OT_give_time(MarkOperator, bpy.types.Operator):
    """Give this boundary a time: the first is the start, the second the end, more lie between"""

    bl_idname = names.OP_GIVE_TIME
    bl_label = "Give It a Time"

    index: IntProperty(name="Finding", min=0)

    def change(self, context, ob):
        problem, session = sessions.finding(ob, self.index)
        knit, scale = session.value("check"), session.results["check"].scale
        for boundary in problem["elements"].get("boundaries", ()):
            rows = knit.surface.boundaries[boundary]["vertices"]
            time = mark_lists.suggested_time(ob.data)
            opening = next((r.opening for r in knit.rims if set(r.vertices) == set(rows)), None)
            if opening is not None:
                mark_lists.set_time(ob.data, mark_lists.OPENINGS, opening, time)
                continue
            vertices, _ = knit.arrays(sessions.read_as_it_is(context, ob)[0])
            place = ob.matrix_world.inverted_safe() @ Vector(vertices[rows[0]] / scale)
            edges = constraints.boundary_near(ob.data, place)
            if edges is None:
                raise UsageError(names.MADE_BY_MODIFIER)
            number = len(mark_lists.CONSTRAINTS.entries(ob.data)) + 1
            constraints.add_constraint(ob.data, edges, time, f"Boundary {number}")


CLASSES = (MESHKNIT_OT_give_time,)
