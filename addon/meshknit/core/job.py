"""A run in a thread of its own. The thread touches no Blender data."""

import threading
import traceback


class Job:
    """Runs work(context) -> value in a thread; `context` is a RunContext of the library."""

    def __init__(self, work, context):
        self.context = context
        self.value = None
        self.error = None  # text of an error that work() should not have had
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)
        self._thread.start()

    def _run(self, work):
        try:
            self.value = work(self.context)
        except Exception:  # the thread's end: handed on as text, shown by the one who waits
            self.error = traceback.format_exc()

    @property
    def running(self):
        return self._thread.is_alive()

    @property
    def progress(self):
        return self.context.progress

    def cancel(self):
        self.context.cancel()

    def wait(self, seconds=None):
        self._thread.join(seconds)
