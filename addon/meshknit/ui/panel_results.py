"""The sidebar's Knit tab: numbers, problems, display."""

import textwrap

import bpy

from .. import names
from ..core.report import summary_lines
from ..scene import sessions
from .panel import KnitPanel

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
            layout.label(text="Of an earlier state: " + ", ".join(stale), icon="FILE_REFRESH")
        lines = layout.column(align=True)
        lines.active = not stale
        for name, value in summary_lines(session.report):
            row = lines.row()
            row.label(text=name)
            row.label(text=value)
        width = max(16, (context.region.width - 50) // 7)  # characters
        for index, problem in enumerate(session.problems[:MOST_PROBLEMS]):
            self._draw_problem(layout.box(), index, problem, width)
        left = len(session.problems) - MOST_PROBLEMS
        if left > 0:
            layout.label(text=f"and {left} more, in the report")

    def _draw_problem(self, box, index, problem, width):
        column = box.column(align=True)
        icon = ICONS[problem["severity"]]
        for text in (problem["message"], problem["remedy"]):
            for line in textwrap.wrap(text, width):
                column.label(text=line, icon=icon)
                icon = "BLANK1"
        if problem["elements"]:
            select = box.operator(names.OP_SELECT_PROBLEM, text="Show", icon="VIEWZOOM")
            select.index = index


class MESHKNIT_PT_display(KnitPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_display"
    bl_label = "Display"
    bl_parent_id = names.PANEL

    def draw(self, context):
        scene = getattr(context.scene, names.PROPERTIES)
        self.layout.prop(scene, "show_time")
        self.layout.prop(scene, "show_graph")


CLASSES = (MESHKNIT_PT_results, MESHKNIT_PT_display)
