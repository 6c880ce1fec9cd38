"""The sidebar's Knit tab: what there is to know before the graph is built."""

import bpy

from .. import compat, names
from ..core.guidance import GIVE_TIME, MEND, SELECT, SUGGEST
from ..scene import live, sessions
from .panel import KnitSubPanel
from .problems import draw_problems
from .text import draw_text, draw_value

WORK = {live.FIELD: "Time field", live.JUDGE: "Guidance", live.GRAPH: "Knit graph"}


class MESHKNIT_PT_guidance(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_guidance"
    bl_label = "Before Knitting"

    def draw(self, context):
        layout = self.layout
        layout.prop(getattr(context.scene, names.PROPERTIES), "live_graph")
        work = live.progress()
        if work is not None:
            compat.draw_progress(layout, work[1], WORK[work[0]])
        session = sessions.known_session(context.object)
        guidance = session.guidance if session is not None else None
        if guidance is None:
            if not sessions.is_wanted(context.object):
                draw_text(
                    layout, context, "Give boundaries a time, or let openings and times be chosen:"
                )
                layout.operator(names.OP_SUGGEST, icon="LIGHT")
            return
        column = layout.column()
        column.active = session.is_guidance_fresh()
        for name, value in guidance.numbers:
            draw_value(column, name, value)
        for saddle in guidance.saddles:
            draw_value(column, f"At {saddle.time:.2f}", saddle.text())
        draw_problems(column, context, guidance.problems, self._draw_buttons)
        if not guidance.problems:
            column.label(text="Nothing stands in the way", icon="CHECKMARK")

    def _draw_buttons(self, buttons, index, problem):
        if GIVE_TIME in problem["actions"]:
            buttons.operator(names.OP_GIVE_TIME, icon="TIME").index = index
        if MEND in problem["actions"]:
            buttons.operator(names.OP_MEND_TIME, icon="MODIFIER")
        if SELECT in problem["actions"]:
            buttons.operator(names.OP_SELECT_FINDING, text="Show", icon="VIEWZOOM").index = index
        if SUGGEST in problem["actions"]:
            buttons.operator(names.OP_SUGGEST, icon="LIGHT")


class MESHKNIT_PT_suggestions(KnitSubPanel, bpy.types.Panel):
    bl_idname = "MESHKNIT_PT_suggestions"
    bl_label = "Suggestions"

    def draw(self, context):
        layout = self.layout
        layout.operator(names.OP_SUGGEST, icon="LIGHT").choice = 0
        session = sessions.known_session(context.object)
        if session is None or session.suggestions is None:
            return
        for index, entry in enumerate(session.suggestions.entries):
            box = layout.box()
            draw_text(box, context, entry["summary"])
            applied = session.suggestions.applied == index
            apply = box.operator(
                names.OP_SUGGEST,
                text="Applied" if applied else "Apply",
                icon="CHECKMARK" if applied else "NONE",
                depress=applied,
            )
            apply.choice = index


CLASSES = (MESHKNIT_PT_guidance, MESHKNIT_PT_suggestions)
