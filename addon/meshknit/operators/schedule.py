"""Trace the stitches and place them on the machine's needles."""

import bpy

from .. import names
from .stage_base import StageOperator


class MESHKNIT_OT_schedule(StageOperator, bpy.types.Operator):
    """Trace the stitches and find needles for every one"""

    bl_idname = names.OP_SCHEDULE
    bl_label = "Schedule"
    until = "schedule"

    def good_news(self, report):
        return f"{report['trace']['stitches']} stitches have their needles"


CLASSES = (MESHKNIT_OT_schedule,)
