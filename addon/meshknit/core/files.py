"""The files that a run writes. Each is written whole or not at all."""

import json
import os
import tempfile
from pathlib import Path

from .errors import UsageError


def write_whole(path, text):
    """Writes UTF-8 text to a temporary file beside `path` and renames it. Throws UsageError."""
    path, data = Path(path), text.encode("utf-8")
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except OSError as error:
        if temporary and os.path.exists(temporary):
            os.unlink(temporary)
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


def _umask():
    """What new files are not allowed; the system tells only while changing it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


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
    return json.dumps(report, indent=1, ensure_ascii=False) + "\n"


def _json(value):
    return json.dumps(value, separators=(",", ":")) + "\n"
