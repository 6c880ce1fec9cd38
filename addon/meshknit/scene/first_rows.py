"""What is knit so far of a graph that is being made."""

from . import sessions


def show(context, ob, work):
    """Takes what there is since the last look, and draws it."""
    rows = work.first_rows.take()
    if rows is not None and len(rows.nodes):
        sessions.session_of(ob).show_first_rows((rows, work.model.scale))
        sessions.redraw(context)
