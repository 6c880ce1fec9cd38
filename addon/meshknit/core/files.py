"""The files that a run writes. Each is written whole or not at all."""

import json
import math
import os
import stat
import tempfile

from .errors import UsageError


def target_of(path):
    """The file that writing to `path` changes: links are followed. Throws UsageError for what
    cannot become a file."""
    target = os.path.realpath(path)
    if not os.path.isdir(os.path.dirname(target)):
        raise UsageError(f"cannot write {path}: its folder does not exist")
    if os.path.lexists(target) and not os.path.isfile(target):
        raise UsageError(f"cannot write {path}: it is no file but a folder, device or the like")
    return target


def write_whole(path, text):
    """Writes UTF-8 text to a temporary file beside the target and renames it. An existing file
    keeps its mode. Throws UsageError."""
    target, data = target_of(path), text.encode("utf-8")
    folder, name = os.path.split(target)
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=folder, prefix=f".{name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.chmod(temporary, _mode(target))
        os.replace(temporary, target)
    except OSError as error:
        if temporary and os.path.exists(temporary):
            os.unlink(temporary)
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


def _mode(target):
    """What the file has, or what a new file gets."""
    if os.path.exists(target):
        return stat.S_IMODE(os.stat(target).st_mode)
    mask = os.umask(0o077)  # the system tells what new files are not allowed only while changing it
    os.umask(mask)
    return 0o666 & ~mask


def sheet_of(path):
    """Where the run sheet of a machine file stands."""
    return f"{path}.txt"


def machine_files(knitout, output, kcode):
    """(path, text) of every file for the machine, each followed by its run sheet. None for a path:
    not wanted."""
    files = []
    for path, text in ((output, knitout.text), (kcode, knitout.kcode)):
        if path is not None:
            files += [(path, text), (sheet_of(path), knitout.sheet)]
    return files


def graph_text(graph):
    """The knit graph as meshknit-graph-1."""
    return _json(
        {
            "format": "meshknit-graph-1",
            "stitch_width": graph.stitch_width,
            "stitch_height": graph.stitch_height,
            "nodes": graph.nodes.tolist(),
            "rows": graph.rows,
            "columns": graph.columns.tolist(),
            "row_lengths": graph.row_lengths,
            "column_lengths": graph.column_lengths.tolist(),
        }
    )


def stitches_text(trace):
    """The traced stitches as meshknit-stitches-1."""
    return _json({"format": "meshknit-stitches-1", "stitches": trace.stitches})


def report_text(report):
    """The report as JSON; what is no finite number, as the area of a broken mesh, is null."""
    return json.dumps(_finite(report), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _finite(value):
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _json(value):
    return json.dumps(value, separators=(",", ":"), allow_nan=False) + "\n"
