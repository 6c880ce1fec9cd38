"""Write the machine file."""

import os
import tempfile
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .. import names
from ..core.errors import UsageError
from ..core.files import graph_text, machine_files, report_text, stitches_text, write_whole
from ..core.workflow import stage_keys
from ..scene import sessions
from ..scene.edit_mode import active_mesh
from .stage_base import StageOperator


class MESHKNIT_OT_write_knitout(StageOperator, bpy.types.Operator):
    """Write the program for the machine, after a simulated machine has knit it as planned"""

    bl_idname = names.OP_WRITE
    bl_label = "Write"
    until = "emit"

    output: StringProperty(
        name="Machine file",
        description="Left empty: the file chosen in the panel, or one named after the object, "
        "beside the .blend file or in your documents. A folder gets a file named after the object",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    kcode: StringProperty(
        name="Kniterate file",
        description="Left empty: on a Kniterate, a .kc file beside the machine file",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    graph: StringProperty(name="Knit graph file", subtype="FILE_PATH", options={"SKIP_SAVE"})
    stitches: StringProperty(name="Stitches file", subtype="FILE_PATH", options={"SKIP_SAVE"})
    report_file: StringProperty(name="Report file", subtype="FILE_PATH", options={"SKIP_SAVE"})

    def _prepare(self, context):
        chosen = self.output or getattr(context.scene, names.PROPERTIES).output
        self._path = _machine_file(chosen, active_mesh(context))
        return super()._prepare(context)

    def published(self, context, ob, outcome, report):
        values = {stage: result.value for stage, result in outcome.results.items()}
        files = [
            (self.graph, lambda: graph_text(values["graph"])),
            (self.stitches, lambda: stitches_text(values["trace"])),
            (self.report_file, lambda: report_text(report)),
        ]
        try:
            kcode = self._kcode_file(values["emit"])
            for path, text in files:
                if path:
                    write_whole(bpy.path.abspath(path), text())
            for path, text in machine_files(values["emit"], str(self._path), kcode):
                write_whole(path, text)
            sessions.session_of(ob).written = str(self._path)
            now = stage_keys(*sessions.read_inputs(context, ob))
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if now != outcome.keys:
            text = f"{self._path} was written from the values before your change: write it again"
            self.report({"WARNING"}, text)
            return {"FINISHED"}
        return super().published(context, ob, outcome, report)

    def _kcode_file(self, knitout):
        """Where the Kniterate's own file goes; None for other machines."""
        chosen = self.kcode.strip()
        if not knitout.kcode:
            if chosen:
                raise UsageError("only the machine Kniterate takes .kc files")
            return None
        return bpy.path.abspath(chosen) if chosen else str(self._path.with_suffix(".kc"))

    def good_news(self, report):
        minutes = report["program"]["estimated_minutes"]
        return f"Checked and written: {self._path} (about {minutes:.0f} minutes to knit)"


def _machine_file(chosen, ob):
    """Where the program goes: `chosen`, ending in .k; in a folder, or where nothing is chosen, a
    file named after the object."""
    own_name = f"{bpy.path.clean_name(ob.name)}.k"
    if not chosen.strip():
        return _default_folder() / own_name
    text = bpy.path.abspath(chosen.strip())
    path = Path(os.path.abspath(text))
    if path.is_dir() or text.endswith(("/", os.sep)):
        return path / own_name
    return path if path.suffix.lower() == ".k" else path.with_name(path.name + ".k")


def _default_folder():
    """Beside the .blend file, else the user's documents, else wherever files may be written."""
    if bpy.data.filepath:
        return Path(bpy.data.filepath).parent
    home = Path.home()
    for folder in (home / "Documents", home):
        if folder.is_dir() and os.access(folder, os.W_OK):
            return folder
    return Path(tempfile.gettempdir())


CLASSES = (MESHKNIT_OT_write_knitout,)
