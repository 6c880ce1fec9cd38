"""Suggest openings and times."""

import bpy
from bpy.props import IntProperty

from .. import names
from ..core.errors import UsageError
from ..core.suggestions import find_suggestions, suggestions_key
from ..scene import sessions, undo
from ..scene.apply_suggestion import apply_suggestion
from ..scene.edit_mode import object_mode
from .mark_base import poll_marks
from .stage_base import StageOperator


class MESHKNIT_OT_suggest(StageOperator, bpy.types.Operator):
    """Let meshknit choose openings and times. They take the place of those that are there, and can be
    edited afterwards"""

    bl_idname = names.OP_SUGGEST
    bl_label = "Suggest"

    choice: IntProperty(
        name="Choice",
        description="Which of the suggestions: 0 is the best",
        min=0,
        max=2,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context):
        return poll_marks(cls, context)

    def _work(self, library, model, settings, session):
        key, known = suggestions_key(model, settings), session.suggestions
        if known is not None and known.key == key:
            return lambda run: known
        return lambda run: find_suggestions(library, model, settings, run)

    def _finish(self, context, found):
        if found is None:
            self.report({"INFO"}, "Cancelled; openings and times stay")
            return {"CANCELLED"}
        ob = self._find_object(context)
        if ob is None:
            return {"CANCELLED"}
        session = sessions.session_of(ob)
        if found.message:
            session.problems, session.message = list(found.problems), found.message
            self.report({"ERROR"}, found.message)
            return {"CANCELLED"}
        session.suggestions = found
        if self.choice >= len(found.entries):
            self.report({"ERROR"}, f"There are {len(found.entries)} suggestions, counted from 0")
            return {"CANCELLED"}
        entry = found.entries[self.choice]
        try:
            with object_mode(ob):
                apply_suggestion(ob, entry, self._model.scale)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        found.applied = self.choice
        sessions.touch(ob)
        undo.keep_lists(ob)
        self.report({"INFO"}, entry["summary"])
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_suggest,)
