"""What the operators of all stages share: execute() runs to the end, invoke() in a thread."""

import bpy

from .. import compat, native
from ..core.errors import UsageError
from ..core.job import Job
from ..core.report import build_report
from ..core.workflow import run_stages
from ..scene import live, sessions
from ..scene.edit_mode import active_mesh, hidden_text, object_mode
from ..scene.time_attribute import publish_time
from . import running_step


def poll_mesh(cls, context):
    """True if the active object is a mesh that can be read and nothing runs; says why not where
    Blender can."""
    ob = active_mesh(context)
    if ob is None:
        cls.poll_message_set("Choose a mesh object")
        return False
    if ob.mode != "OBJECT" and not ob.visible_get():
        cls.poll_message_set(hidden_text(ob))
        return False
    if sessions.job() is not None:
        cls.poll_message_set("A step is running; Esc cancels it")
        return False
    return True


class StageOperator:
    """Mixin. Subclasses set `until`, the stage to run to; earlier ones run if missing or stale."""

    bl_options = {"REGISTER", "UNDO"}
    until = ""

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        work = self._prepare(context)
        if work is None:
            return {"CANCELLED"}
        return self._finish(context, work(native.load().RunContext()))

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        work = self._prepare(context)
        if work is None:
            return {"CANCELLED"}
        self._job = Job(work, native.load().RunContext())
        self._shown = running_step.RunningStep(context, self.bl_label, self._job)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._job.cancel()
            return {"RUNNING_MODAL"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if self._job.running:
            self._shown.update(context)
            return {"PASS_THROUGH"}
        self._shown.end(context)
        if self._job.error:
            self.report({"ERROR"}, f"Please report this: {self._job.error}")
            return {"CANCELLED"}
        return self._finish(context, self._job.value)

    def cancel(self, context):
        """Blender closes, or loads another file, while the job runs."""
        running_step.stop(context)

    def _prepare(self, context):
        """Reads all that the run needs. -> a function of a RunContext that returns the outcome,
        or None after saying why not."""
        ob = active_mesh(context)
        live.give_way()
        try:
            library = native.load()
            self._model, self._settings = sessions.read_inputs(context, ob)
        except (native.NativeMissing, UsageError) as error:
            self.report({"ERROR"}, str(error))
            return None
        self._key, self._name = compat.object_key(ob), ob.name
        return self._work(library, self._model, self._settings, sessions.session_of(ob))

    def _work(self, library, model, settings, session):
        """-> what the thread does: a function of a RunContext that touches no Blender data."""
        until, known = self.until, dict(session.results)
        return lambda run: run_stages(library, model, settings, until, run, known)

    def _finish(self, context, outcome):
        """Publishes the outcome; on the main thread."""
        if outcome.status == "cancelled":
            self.report({"INFO"}, "Cancelled; the earlier results stay")
            return {"CANCELLED"}
        ob = self._find_object(context)
        if ob is None:
            return {"CANCELLED"}
        report = build_report(native.load(), self._model, self._settings, outcome)
        sessions.session_of(ob).adopt(outcome, report)
        if "time" in outcome.results and self._model.own_time is None:
            try:
                with object_mode(ob):
                    knit, times = (outcome.results[s].value for s in ("check", "time"))
                    publish_time(ob, self._model, knit.times_for_model(times[0]))
            except UsageError as error:
                self.report({"WARNING"}, f"The time colours could not be shown: {error}")
        sessions.touch(ob)
        if not outcome.ok:
            self.report({"ERROR"}, outcome.message)
            return {"CANCELLED"}
        return self.published(context, ob, outcome, report)

    def _find_object(self, context):
        """What the run was about, or None after saying that it is not there."""
        ob = sessions.object_of(context.scene, self._key)
        if ob is None:
            text = f"{self._name} is not in this scene any more; what was found is dropped"
            self.report({"WARNING"}, text)
        return ob

    def published(self, context, ob, outcome, report):
        """What the stage does with its result beyond showing it."""
        self.report({"INFO"}, self.good_news(report))
        return {"FINISHED"}

    def good_news(self, report):
        """One line for people."""
        raise NotImplementedError
