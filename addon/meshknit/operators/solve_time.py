"""Interpolate the time field."""

import bpy

from .. import names
from .stage_base import StageOperator


class MESHKNIT_OT_solve_time(StageOperator, bpy.types.Operator):
    """Interpolate the knitting time between the constraints, and show it as colours"""

    bl_idname = names.OP_SOLVE_TIME
    bl_label = "Solve Time"
    until = "time"

    def good_news(self, report):
        return "The time field is smooth from the first boundary to the last"


CLASSES = (MESHKNIT_OT_solve_time,)
