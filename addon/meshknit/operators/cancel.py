"""Cancel the running step."""

import bpy

from .. import names
from ..scene import sessions


class MESHKNIT_OT_cancel(bpy.types.Operator):
    """Stop the running step; earlier results stay"""

    bl_idname = names.OP_CANCEL
    bl_label = "Cancel"

    @classmethod
    def poll(cls, context):
        if sessions.job() is None:
            cls.poll_message_set("No step is running")
            return False
        return True

    def execute(self, context):
        sessions.job().cancel()
        return {"FINISHED"}


CLASSES = (MESHKNIT_OT_cancel,)
