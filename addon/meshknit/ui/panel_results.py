"""The sidebar's Knit tab: numbers, problems, display."""

import bpy

from .. import names
from ..core.report import summary_lines
from ..scene import sessions
from .panel import KnitPanel
from .text import draw_text, draw_value

ICONS = {"error": "CANCEL", "warning": "ERROR", "note": "INFO"}
MOST_PROBLEMS = 12


class MESHKNIT_PT_results(KnitPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_results"
    bl_label = "Result"
    bl_parent_id = names.PANEL

    def draw(self, context):
        layout = self.layout
        session = sessions.known_session(context.object)
        if session is None or not session.report:
            layout.label(text="Nothing built yet")
            return
        stale = session.stale_stages()
        if stale:
            draw_text(layout, context, "Out of date: " + ", ".join(stale), "FILE_REFRESH")
        lines = layout.column(align=True)
        lines.active = not stale
        for name, value in summary_lines(session.report):
            draw_value(lines, name, value)
        if session.written:
            draw_text(layout, context, f"Written: {session.written}", "FILE_TICK")
        for index, problem in enumerate(session.problems[:MOST_PROBLEMS]):
            self._draw_problem(context, layout.box(), index, problem)
        left = len(session.problems) - MOST_PROBLEMS
        if left > 0:
            layout.label(text=f"and {left} more")

    def _draw_problem(self, context, box, index, problem):
        draw_text(box, context, problem["message"], ICONS[problem["severity"]])
        draw_text(box, context, problem["remedy"], "BLANK1")
        if problem["elements"]:
            select = box.operator(names.OP_SELECT_PROBLEM, text="Show", icon="VIEWZOOM")
            select.index = index
        if problem["code"] == "seam-needed":
            box.operator(names.OP_ALLOW_SEAMS, icon="MOD_EXPLODE")


class MESHKNIT_PT_display(KnitPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_display"
    bl_label = "Display"
    bl_parent_id = names.PANEL

    def draw(self, context):
        scene = getattr(context.scene, names.PROPERTIES)
        self.layout.prop(scene, "show_time")
        self.layout.prop(scene, "show_graph")


CLASSES = (MESHKNIT_PT_results, MESHKNIT_PT_display)
