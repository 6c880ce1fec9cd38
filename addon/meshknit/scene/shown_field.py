"""The live field of the active object as it is drawn."""

from dataclasses import dataclass, replace

import numpy as np
from mathutils import Matrix

from .. import compat, names
from ..core.live_field import LiveField
from . import sessions


@dataclass(frozen=True)
class Shown:
    """Places are in the world as it was when the object was read, when its matrix was `matrix`."""

    key: object  # of the object
    live: LiveField
    matrix: Matrix
    values: tuple  # of the chains' times
    times: np.ndarray  # one a vertex
    rows: np.ndarray  # how many rows lie below each vertex
    height: float  # of a stitch, mm, for the rows
    stale: bool
    revision: int  # other for every other content


_shown = None
_revision = 0


def shown(ob):
    """The field of an object as it is to be drawn, or None."""
    if _shown is None or ob is None or _shown.key != compat.object_key(ob):
        return None
    return _shown


def forget():
    global _shown
    _shown = None


def adopt(context, ob, live, matrix):
    """Shows a field, None being nothing. -> False if the object's lists are not what it was made
    from any more."""
    if live is None:
        forget()
        return True
    values = _times_of(ob, live.sources)
    if values is not None:
        _show(context, ob, live, matrix, values)
    return values is not None


def follow(context, ob):
    """Shows the times as they are now; results made with others are stale at once. -> False if there
    is no field whose chains are those of the lists."""
    held = shown(ob)
    values = _times_of(ob, held.live.sources) if held is not None else None
    if values is None:
        return False
    if values != held.values:
        _show(context, ob, held.live, held.matrix, values)
        sessions.session_of(ob).look_at({"check": held.live.keys["check"]})
    return True


def grey(context, ob):
    """What is shown, and what was built, may not be the object's any more."""
    global _shown, _revision
    if shown(ob) is not None and not _shown.stale:
        _revision += 1
        _shown = replace(_shown, stale=True, revision=_revision)
        sessions.session_of(ob).look_at({})
        sessions.redraw(context)


def _times_of(ob, sources):
    """-> the times that an object's lists say, or None if the sources are not there."""
    settings, values = getattr(ob.data, names.PROPERTIES), []
    for name, index in sources:
        if name == "drawn":
            values.append(index)
            continue
        entries = getattr(settings, name)
        if index >= len(entries) or (name == "openings" and not entries[index].has_time):
            return None
        values.append(round(entries[index].time, 6))
    return tuple(values)


def _show(context, ob, live, matrix, values):
    global _shown, _revision
    height = round(getattr(context.scene, names.PROPERTIES).stitch_height, 6)
    held = shown(ob)
    same = held is not None and (held.live.shape, held.live.solver) == (live.shape, live.solver)
    if same and live.own_time is None and (held.values, held.height) == (values, height):
        _shown = replace(held, live=live, matrix=matrix, stale=False)
        return
    _revision += 1
    times = live.times(values)
    rows = live.rows(times, height)
    key = compat.object_key(ob)
    _shown = Shown(key, live, matrix, values, times, rows, height, False, _revision)
    sessions.redraw(context)
