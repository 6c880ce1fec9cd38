"""The files that a run writes. Each is written whole or not at all."""

import json
import os
import tempfile
from pathlib import Path

from .errors import UsageError


def write_whole(path, text):
    """Writes UTF-8 text to a temporary file beside `path` and renames it. Throws UsageError."""
    path = Path(path)
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=path.parent or ".", prefix=f".{path.name}.")
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(temporary, 0o666 & ~umask)
        os.replace(temporary, path)
    except OSError as error:
        if temporary and os.path.exists(temporary):
            os.unlink(temporary)
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


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
