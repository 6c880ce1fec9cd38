"""The sidebar's Knit tab: numbers, problems, display."""

import bpy

from .. import names
from ..core.report import summary_lines
from ..scene import sessions
from .panel import KnitSubPanel
from .problems import ICONS, draw_problems
from .text import draw_text, draw_value


class MESHKNIT_PT_results(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_results"
    bl_label = "Result"

    def draw(self, context):
        layout = self.layout
        session = sessions.known_session(context.object)
        if session is None or not session.report:
            layout.label(text="Nothing built yet")
        if session is None:
            return
        if session.untold():
            draw_text(layout.box(), context, session.untold(), ICONS["error"])
        if session.report:
            self._draw_report(context, session)
        if session.written:
            draw_text(layout, context, f"Written: {session.written}", "FILE_TICK")
        draw_problems(layout, context, session.problems, self._draw_buttons)

    def _draw_report(self, context, session):
        layout = self.layout
        stale = session.stale_stages()
        if stale:
            draw_text(layout, context, "Out of date: " + ", ".join(stale), "FILE_REFRESH")
        lines = layout.column(align=True)
        lines.active = not stale
        for name, value in summary_lines(session.report):
            draw_value(lines, name, value)

    def _draw_buttons(self, buttons, index, problem):
        if problem["elements"]:
            select = buttons.operator(names.OP_SELECT_PROBLEM, text="Show", icon="VIEWZOOM")
            select.index = index
        if problem["code"] == "seam-needed":
            buttons.operator(names.OP_ALLOW_SEAMS, icon="MOD_EXPLODE")


class MESHKNIT_PT_display(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_display"
    bl_label = "Display"

    def draw(self, context):
        scene = getattr(context.scene, names.PROPERTIES)
        self.layout.prop(scene, "show_time")
        self.layout.prop(scene, "show_graph")


CLASSES = (MESHKNIT_PT_results, MESHKNIT_PT_display)
