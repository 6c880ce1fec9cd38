"""Select what a problem or a finding of the guidance is about."""

import bpy
from bpy.props import IntProperty

from .. import names
from ..core.errors import UsageError
from ..scene import sessions
from ..scene.edit_mode import active_mesh
from ..scene.select_elements import nearest_vertices, select_elements
from .stage_base import poll_mesh


class SelectOperator:
    """Mixin. Subclasses have problem(ob) -> (problem, session); it throws UsageError."""

    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(name="Index", min=0)

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        try:
            problem, session = self.problem(ob)
            model, _ = sessions.read_inputs(context, ob)
            if len(model.vertices) != len(ob.data.vertices):
                text = "Modifiers change the vertices: apply them to see the place"
                self.report({"WARNING"}, text)
                return {"CANCELLED"}
            found = _select(context, ob, model, problem["elements"], session)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not found:
            self.report({"WARNING"}, "This problem names no part of the mesh as it is now")
        return {"FINISHED"}


def _select(context, ob, model, elements, session):
    """-> how many elements were selected. Throws UsageError."""
    vertices = list(elements.get("vertices", ()))
    knit, graph = session.value("check"), session.value("graph")
    if knit is not None:
        loops = knit.surface.boundaries
        for boundary in elements.get("boundaries", ()):
            vertices += knit.model_rows(model, loops[boundary]["vertices"])
    nodes = list(elements.get("nodes", ()))
    if session.value("trace") is not None:
        nodes += session.value("trace").nodes[list(elements.get("stitches", ()))].tolist()
    if graph is not None and nodes:
        vertices += nearest_vertices(model.vertices, graph.nodes[nodes, :3])
    return select_elements(
        context, ob, vertices, elements.get("edges", ()), elements.get("faces", ())
    )


class MESHKNIT_OT_select_problem(SelectOperator, bpy.types.Operator):
    """Select the vertices, edges, faces or boundaries that this problem is about"""

    bl_idname = names.OP_SELECT_PROBLEM
    bl_label = "Select Problem"

    def problem(self, ob):
        session = sessions.session_of(ob)
        if self.index >= len(session.problems):
            raise UsageError(f"There is no problem {self.index}")
        return session.problems[self.index], session


class MESHKNIT_OT_select_finding(SelectOperator, bpy.types.Operator):
    """Select the part of the mesh that this is about"""

    bl_idname = names.OP_SELECT_FINDING
    bl_label = "Show on the Mesh"

    def problem(self, ob):
        return sessions.finding(ob, self.index)


CLASSES = (MESHKNIT_OT_select_problem, MESHKNIT_OT_select_finding)
