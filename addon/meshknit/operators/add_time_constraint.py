"""Give a time to a chain of edges."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatVectorProperty, StringProperty
from mathutils import Vector

from .. import names, native
from ..core.edge_chains import nearest_vertex
from ..core.errors import UsageError
from ..core.marks import parse_points
from ..scene import constraints
from ..scene.attributes import positions
from .mark_base import MarkOperator, time_property


class MESHKNIT_OT_add_time_constraint(MarkOperator, bpy.types.Operator):
    """Give a time to the selected edges (one chain or loop). Scripts may name a boundary or points
    in world space instead"""

    bl_idname = names.OP_ADD_CONSTRAINT
    bl_label = "Add from Selected Edges"

    time: time_property("these edges are")
    boundary_near: FloatVectorProperty(
        name="Boundary near",
        description="For scripts: the boundary nearest to this place",
        size=3,
        options={"HIDDEN", "SKIP_SAVE"},
    )
    points: StringProperty(
        name="Points",
        description='For scripts: places on the surface, "[[x, y, z], ...]"',
        options={"HIDDEN", "SKIP_SAVE"},
    )
    closed: BoolProperty(
        name="Closed",
        description="For scripts: join the last point to the first",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def change(self, context, ob):
        edges = self._edges(ob)
        constraints.add_constraint(ob.data, edges, self.time)

    def _edges(self, ob):
        """Throws UsageError."""
        mesh, to_local = ob.data, ob.matrix_world.inverted_safe()
        if self.properties.is_property_set("boundary_near"):
            loop = constraints.boundary_near(mesh, to_local @ Vector(self.boundary_near))
            if loop is None:
                raise UsageError("The mesh has no boundary")
            return loop
        if self.points:
            at = positions(mesh)
            places = [to_local @ Vector(point) for point in parse_points(self.points)]
            stops = [nearest_vertex(at, np.asarray(place)) for place in places]
            library = native.load()
            return constraints.path_through(library, mesh, stops, self.closed, ob.matrix_world)
        return constraints.selected_chain(mesh)


CLASSES = (MESHKNIT_OT_add_time_constraint,)
