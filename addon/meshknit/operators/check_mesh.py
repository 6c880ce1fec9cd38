"""Check the mesh."""

import bpy

from .. import names
from .stage_base import StageOperator


class MESHKNIT_OT_check_mesh(StageOperator, bpy.types.Operator):
    """Check that the mesh is one oriented surface with at least two boundaries"""

    bl_idname = names.OP_CHECK
    bl_label = "Check"
    until = "check"

    def good_news(self, report):
        mesh = report["mesh"]
        return f"The mesh can be knit: {mesh['boundaries']} boundaries, {mesh['faces']} triangles"


CLASSES = (MESHKNIT_OT_check_mesh,)
