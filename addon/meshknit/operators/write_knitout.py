"""Write the machine file."""

from pathlib import Path

import bpy
from bpy.props import StringProperty

from .. import names
from ..core.errors import UsageError
from ..core.files import graph_text, report_text, stitches_text, write_whole
from ..scene.edit_mode import active_mesh
from .stage_base import StageOperator


class MESHKNIT_OT_write_knitout(StageOperator, bpy.types.Operator):
    """Write the program for the machine, after a simulated machine has knit it as planned"""

    bl_idname = names.OP_WRITE
    bl_label = "Write"
    until = "emit"

    output: StringProperty(
        name="Machine file",
        description="Left empty: the file chosen in the panel, or one beside the .blend file",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    graph: StringProperty(name="Knit graph file", subtype="FILE_PATH", options={"SKIP_SAVE"})
    stitches: StringProperty(name="Stitches file", subtype="FILE_PATH", options={"SKIP_SAVE"})
    report_file: StringProperty(name="Report file", subtype="FILE_PATH", options={"SKIP_SAVE"})

    def _prepare(self, context):
        self._path = self.output or getattr(context.scene, names.PROPERTIES).output
        if not self._path and bpy.data.filepath:
            self._path = f"//{bpy.path.clean_name(active_mesh(context).name)}.k"
        if not self._path:
            self.report({"ERROR"}, "Choose a machine file in the panel, or save the .blend file")
            return None
        self._path = Path(bpy.path.abspath(self._path))
        if not self._path.suffix:
            self._path = self._path.with_suffix(".k")
        return super()._prepare(context)

    def published(self, context, ob, outcome, report):
        values = {stage: result.value for stage, result in outcome.results.items()}
        files = (
            (self.graph, lambda: graph_text(values["graph"])),
            (self.stitches, lambda: stitches_text(values["trace"])),
            (self.report_file, lambda: report_text(report)),
            (str(self._path), lambda: values["emit"].text),
        )
        try:
            for path, text in files:
                if path:
                    write_whole(bpy.path.abspath(path), text())
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return super().published(context, ob, outcome, report)

    def good_news(self, report):
        minutes = report["program"]["estimated_minutes"]
        return f"Checked and written: {self._path} (about {minutes:.0f} minutes to knit)"


CLASSES = (MESHKNIT_OT_write_knitout,)
