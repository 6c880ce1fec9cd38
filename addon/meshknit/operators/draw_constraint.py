"""Lay a time constraint with the mouse."""

import json

import bpy
from bpy.props import BoolProperty, IntProperty, StringProperty

from .. import names, native
from ..core.chain_drawing import ChainDrawing
from ..core.errors import UsageError
from ..core.marks import parse_vertices
from ..overlay import stroke
from ..scene import constraints, mark_lists
from .edit_mark import pick
from .mark_base import MarkOperator, time_property
from .stroke_base import StrokeOperator, new_time

CLICK = 4  # pixels at scale 1: a press that moves no farther is a click


class MESHKNIT_OT_draw_constraint(StrokeOperator, MarkOperator, bpy.types.Operator):
    """Drag over the surface to lay a time constraint along its edges, from the end of one to go on
    with it. Click to select one"""

    bl_idname = names.OP_DRAW_CONSTRAINT
    bl_label = "Draw Constraint"
    keys = "Back over the chain: shorten it   Its first point: close it   Esc: leave"

    time: time_property("the chain is")
    vertices: StringProperty(
        name="Vertices",
        description='For scripts: vertices that the chain leads through, "[12, 40, 41]"',
        options={"HIDDEN", "SKIP_SAVE"},
    )
    closed: BoolProperty(
        name="Closed",
        description="For scripts: join the last vertex to the first",
        options={"HIDDEN", "SKIP_SAVE"},
    )
    index: IntProperty(
        name="Constraint",
        description="For scripts: the constraint that the chain becomes; -1 is a new one",
        default=-1,
        min=-1,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def change(self, context, ob):
        mesh, entries = ob.data, mark_lists.CONSTRAINTS.entries(ob.data)
        if self.index >= len(entries):
            raise UsageError(f"There is no constraint {self.index}")
        stops = parse_vertices(self.vertices)
        library = native.load()
        edges = constraints.path_through(library, mesh, stops, self.closed, ob.matrix_world)
        if self.index < 0:
            constraints.add_constraint(mesh, edges, self.time)
        else:
            index = constraints.redraw_constraint(mesh, self.index, edges)
            mark_lists.set_time(mesh, mark_lists.CONSTRAINTS, index, self.time)

    def begin(self, context, event, ob, canvas, pointer):
        target = pointer.target()
        if target is None:
            return {"CANCELLED"}  # passed on, the press would move the object
        self._target, self._start = target, pointer.mouse
        self._drawing = None
        if target.vertex is None:
            if target.kind == "MODIFIED":
                self.report({"WARNING"}, names.MADE_BY_MODIFIER)
            return None
        chain, closed = [target.vertex], False
        self.index = target.index if target.kind == "END" else -1
        if target.kind == "END":
            chain, closed = canvas.chain_of(target.index)
            if chain[-1] != target.vertex:
                chain = chain[::-1]
        self._drawing = ChainDrawing(canvas.graph, chain, closed)
        self._before = self._drawing.vertices()
        if self.index < 0:
            self.time = new_time(context, ob, self._field_time(pointer, target))
        else:
            self.time = mark_lists.CONSTRAINTS.entries(ob.data)[self.index].time
        return None

    def _field_time(self, pointer, target):
        time = pointer.time(target.hit) if target.hit is not None else None
        return round(time, 2) + 0.0 if time is not None else 0.0

    def follow(self, context, event, ob, canvas, pointer):
        near = CLICK * context.preferences.system.ui_scale
        moved = max(abs(pointer.mouse - self._start)) > near
        if self._drawing is None or not (moved or self._drawing.vertices() != self._before):
            return
        hit = pointer.hit()
        if hit is not None and hit.vertex is not None:
            self._drawing.extend_to(hit.vertex)
        stroke.show(stroke.Stroke(pointer.shown_places(self._drawing.vertices()), self.time))

    def text(self):
        if self._drawing is None or not self._drawing.edge_count:
            return "Drag to lay a constraint"
        kind = "Loop" if self._drawing.closed else "Chain"
        return f"{kind} of {self._drawing.edge_count} edges at time {self.time:.3g}"

    def finish(self, context):
        if self._drawing is not None and self._drawing.vertices() != self._before:
            if self._drawing.edge_count:
                self.vertices = json.dumps(self._drawing.chain)
                self.closed = self._drawing.closed
                return self.execute(context)
            return {"CANCELLED"}
        if self._target.index is None:
            return {"CANCELLED"}
        kind = "OPENING" if self._target.kind == "OPENING" else "CONSTRAINT"
        pick(kind, self._target.index)
        return {"CANCELLED"}


CLASSES = (MESHKNIT_OT_draw_constraint,)
