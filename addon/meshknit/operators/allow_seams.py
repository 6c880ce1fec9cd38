"""Accept the seams that an object needs, and schedule it with them."""

import bpy

from .. import names
from .stage_base import StageOperator


class MESHKNIT_OT_allow_seams(StageOperator, bpy.types.Operator):
    """Knit the object in parts, to be sewn together afterwards, so that no tubes have to cross"""

    bl_idname = names.OP_ALLOW_SEAMS
    bl_label = "Allow Seams to Sew"
    until = "schedule"

    def _prepare(self, context):
        getattr(context.scene, names.PROPERTIES).allow_seams = True
        return super()._prepare(context)

    def good_news(self, report):
        seams = len(report["seams"])
        return f"Knittable with {seams} seam{'' if seams == 1 else 's'} to be sewn"


CLASSES = (MESHKNIT_OT_allow_seams,)
