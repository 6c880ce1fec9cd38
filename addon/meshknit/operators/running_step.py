"""A job that a click started, as Blender shows it: progress at the mouse, text in the status bar."""

import bpy

from ..scene import sessions

POLL_SECONDS = 0.1

_shown = None  # the RunningStep that is shown


class RunningStep:
    """Shows a job from here to end()."""

    def __init__(self, context, label, job):
        global _shown
        self.job, self._label = job, label
        self._manager = context.window_manager
        self._manager.progress_begin(0, 100)
        self._timer = self._manager.event_timer_add(POLL_SECONDS, window=context.window)
        sessions.set_job(job)
        _shown = self

    def update(self, context):
        self._manager.progress_update(int(100 * self.job.progress))
        # A function, not a text: Blender keeps a text with the workspace that was shown when it
        # was set, and takes it away from the one that is shown then.
        context.workspace.status_text_set(self._status_drawing())
        sessions.redraw(context)

    def _status_drawing(self):
        """Blender takes a plain function only, no method."""
        text = f"{self._label}: {self.job.progress:.0%}   |   Esc: cancel"
        return lambda header, context: header.layout.label(text=text)

    def end(self, context):
        global _shown
        _shown = None
        sessions.set_job(None)
        self._manager.event_timer_remove(self._timer)
        self._manager.progress_end()
        bpy.data.workspaces[0].status_text_set(None)
        sessions.redraw(context)


def stop(context):
    """Cancels the job that is shown, if any, and waits for its end."""
    if _shown is not None:
        _shown.job.cancel()
        _shown.job.wait()
        _shown.end(context)
