"""Write the machine file."""

import os
import tempfile
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .. import names
from ..core.errors import UsageError
from ..core.files import (
    graph_text,
    machine_files,
    report_text,
    stitches_text,
    target_of,
    write_whole,
)
from ..core.workflow import stage_keys
from ..scene import sessions
from ..scene.edit_mode import active_mesh
from .stage_base import StageOperator


def _file(name, description):
    return StringProperty(
        name=name, description=description, subtype="FILE_PATH", options={"SKIP_SAVE"}
    )


class MESHKNIT_OT_write_knitout(StageOperator, bpy.types.Operator):
    """Write the program for the machine, after a simulated machine has knit it as planned"""

    bl_idname = names.OP_WRITE
    bl_label = "Write"
    until = "emit"

    output: _file(
        "Machine file",
        "Left empty: the file chosen in the panel, or one named after the object, "
        "beside the .blend file or in your documents. A folder gets a file named after the object",
    )
    kcode: _file("Kniterate file", "Left empty: on a Kniterate, a .kc file beside the machine file")
    graph: _file("Knit graph file", "JSON: rows and columns of the knit graph")
    stitches: _file("Stitches file", "JSON: the traced stitches, in the order of knitting")
    report_file: _file("Report file", "JSON: numbers and problems of every step")

    def _prepare(self, context):
        chosen = self.output or getattr(context.scene, names.PROPERTIES).output
        self._path = _machine_file(chosen, active_mesh(context))
        others = map(_chosen_file, (self.kcode, self.graph, self.stitches, self.report_file))
        try:  # before the work, which may take a while
            for path in (self._path, *filter(None, others)):
                target_of(path)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return None
        return super()._prepare(context)

    def published(self, context, ob, outcome, report):
        values = {stage: result.value for stage, result in outcome.results.items()}
        files = [
            (_chosen_file(self.graph), lambda: graph_text(values["graph"])),
            (_chosen_file(self.stitches), lambda: stitches_text(values["trace"])),
            (_chosen_file(self.report_file), lambda: report_text(report)),
        ]
        try:
            kcode = self._kcode_file(values["emit"])
            for path, text in files:
                if path:
                    write_whole(path, text())
            for path, text in machine_files(values["emit"], str(self._path), kcode):
                write_whole(path, text)
        except UsageError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        sessions.session_of(ob).written = str(self._path)
        if self._keys_now(context, ob) != outcome.keys:
            text = f"{self._path} was written from the values before your change: write it again"
            self.report({"WARNING"}, text)
            return {"FINISHED"}
        return super().published(context, ob, outcome, report)

    def _keys_now(self, context, ob):
        """None where the object cannot be read any more."""
        try:
            return stage_keys(*sessions.read_inputs(context, ob))
        except UsageError:
            return None

    def _kcode_file(self, knitout):
        """Where the Kniterate's own file goes; None for other machines."""
        chosen = _chosen_file(self.kcode)
        if not knitout.kcode:
            if chosen:
                raise UsageError("only the machine Kniterate takes .kc files")
            return None
        return chosen or str(self._path.with_suffix(".kc"))

    def good_news(self, report):
        minutes = report["program"]["estimated_minutes"]
        return f"Checked and written: {self._path} (about {minutes:.0f} minutes to knit)"


def _chosen_file(typed):
    """The full path of what was typed; "" if nothing was."""
    return bpy.path.abspath(typed.strip())


def _machine_file(chosen, ob):
    """Where the program goes: `chosen`, ending in .k; in a folder, or where nothing is chosen, a
    file named after the object."""
    own_name = f"{bpy.path.clean_name(ob.name)}.k"
    if not chosen.strip():
        return _default_folder() / own_name
    text = bpy.path.abspath(chosen.strip())
    path = Path(os.path.abspath(text))
    if os.path.isdir(path) or text.endswith(("/", os.sep)):
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
