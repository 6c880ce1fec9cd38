"""Remesh to a knit graph."""

import bpy

from .. import names
from .stage_base import StageOperator


class MESHKNIT_OT_build_graph(StageOperator, bpy.types.Operator):
    """Lay rows and columns of stitches on the surface"""

    bl_idname = names.OP_BUILD_GRAPH
    bl_label = "Build Graph"
    until = "graph"

    def good_news(self, report):
        graph = report["graph"]
        return f"{graph['rows']} rows, {graph['short_rows']} of them short, {graph['nodes']} nodes"


CLASSES = (MESHKNIT_OT_build_graph,)
