"""Give a time to a chain of edges."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, FloatVectorProperty, StringProperty
from mathutils import Vector

from .. import names
from ..core.edge_chains import connected_groups, is_chain
from ..core.errors import UsageError
from ..core.marks import parse_points
from ..scene import constraints, sessions
from ..scene.edit_mode import active_mesh, object_mode
from .stage_base import poll_mesh


class MESHKNIT_OT_add_time_constraint(bpy.types.Operator):
    """Give a time to the selected edges (one chain or loop). Scripts may name a boundary or points
    in world space instead"""

    bl_idname = names.OP_ADD_CONSTRAINT
    bl_label = "Add from Selected Edges"
    bl_options = {"REGISTER", "UNDO"}

    time: FloatProperty(
        name="Time",
        description="When these edges are knit: -1 is first, 1 is last",
        min=-1.0,
        max=1.0,
        options={"SKIP_SAVE"},
    )
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

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        with object_mode(ob):
            edges, complaint = self._edges(ob)
            if complaint:
                self.report({"ERROR"}, complaint)
                return {"CANCELLED"}
            number = len(getattr(ob.data, names.PROPERTIES).constraints) + 1
            constraints.add_constraint(ob.data, edges, self.time, f"Constraint {number}")
        sessions.touch(ob)
        return {"FINISHED"}

    def _edges(self, ob):
        """-> (edges, None) or (None, what is wrong)"""
        mesh, to_local = ob.data, ob.matrix_world.inverted_safe()
        if self.properties.is_property_set("boundary_near"):
            loop = constraints.boundary_near(mesh, to_local @ Vector(self.boundary_near))
            return loop, None if loop is not None else "The mesh has no boundary"
        if self.points:
            try:
                points = parse_points(self.points)
            except UsageError as error:
                return None, str(error)
            places = [to_local @ Vector(point) for point in points]
            path = constraints.path_through(mesh, places, self.closed)
            return path, None if path else "The points need edges between them"
        chosen = constraints.selected_edges(mesh)
        if not len(chosen):
            return None, "Select the edges that are knit at one time, in Edit Mode"
        groups = connected_groups(constraints.edge_vertices(mesh), chosen)
        if len(groups) > 1 or not is_chain(constraints.edge_vertices(mesh), groups[0]):
            return None, "Select one chain or loop of edges; these branch or fall apart"
        return np.array(groups[0]), None


CLASSES = (MESHKNIT_OT_add_time_constraint,)
