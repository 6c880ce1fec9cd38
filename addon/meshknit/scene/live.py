"""The live field: what is known of the active object while a person works on it.

Changes only mark it as dirty. A timer then does what is due, long work in a thread: the field anew
where surface or chains have changed, one back-solve where times have; after a moment of rest guidance,
and the knit graph. Nothing of Blender's is kept from one tick to the next but names and numbers."""

import time
from dataclasses import dataclass, field, replace

import bpy
from bpy.app.handlers import persistent
from mathutils import Matrix

from .. import compat, names, native
from ..core.errors import UsageError
from ..core.job import Job
from ..core.live_work import build, find_field, judge
from ..core.model import Constraint
from ..core.report import build_report
from . import first_rows, sessions, shown_field
from .edit_mode import active_mesh
from .shown_field import shown

POLL, WAIT = 0.01, 0.1  # seconds between looks at work of our own, and at what others do
REST = 0.25  # seconds without changes before guidance and graph
PATIENCE = 0.15  # seconds that an old field is shown as if nothing had happened

FIELD, JUDGE, GRAPH = "FIELD", "JUDGE", "GRAPH"


@dataclass
class _Work:
    """A job and what it is about."""

    kind: str
    key: object
    job: Job
    model: object
    settings: object
    matrix: Matrix
    began: float
    first_rows: object = None  # of the library, for the graph


@dataclass
class _State:
    key: object = None  # of the object that all of this is about
    changed: set = field(default_factory=set)  # of sessions' words
    last_change: float = 0.0
    inputs: tuple = None  # (model, settings, matrix) as last read, while nothing has changed since
    due: set = field(default_factory=set)  # of FIELD, JUDGE, GRAPH
    drawn: tuple = None  # (vertices, time) of a chain that is being drawn


_state = _State()
_work = None


def progress():
    """-> (kind, fraction) of the work in the background, or None. For drawing."""
    return None if _work is None else (_work.kind, _work.job.progress)


def draw_chain(ob, vertices, time_of_chain):
    """Shows the field as it would be with one more chain of the active object's vertices, while it is
    drawn. The chain is in no list."""
    _set_drawn(ob, (tuple(vertices), time_of_chain) if len(vertices) > 1 else None)


def end_chain():
    """No chain is being drawn any more."""
    _set_drawn(None, None)


def _set_drawn(ob, drawn):
    if drawn != _state.drawn and (drawn is None or sessions.is_wanted(ob)):
        _state.drawn = drawn
        _state.due.update((FIELD, JUDGE, GRAPH))
        _state.last_change = time.monotonic()
        _wake()


def give_way():
    """Lets a step that a person starts go first; what was going on is due again afterwards."""
    if _work is not None and _work.kind != FIELD:
        _work.job.cancel()
        _state.due.add(_work.kind)


def stop():
    """Ends the work in the background, before Blender's data go."""
    global _work
    if _work is not None:
        _work.job.cancel()
        _work.job.wait()
        _work = None


def tick():
    """Does what is due. -> seconds until the next tick, or None if nothing is left."""
    context = bpy.context
    ob = active_mesh(context)
    if _work is not None:
        if (_state.changed or _state.drawn is not None) and _work.kind != FIELD:
            _work.job.cancel()
        if _work.job.running:
            _while_working(context, ob)
            return POLL
        _end_work(context, ob)
    if ob is None or not sessions.is_wanted(ob):
        _forget()
        return None
    if sessions.job() is not None:
        return WAIT
    if compat.object_key(ob) != _state.key:
        _begin_with(ob)
    return _next_step(context, ob)


def _next_step(context, ob):
    if _state.changed:
        _state.inputs = None
    if sessions.TIMES in _state.changed and not shown_field.follow(context, ob):
        _state.changed.add(sessions.ALL)
    _state.changed.discard(sessions.TIMES)
    if ob.mode != "OBJECT":  # attributes cannot be read; a person is at work
        return WAIT if _state.changed or _state.due else None
    if sessions.ALL in _state.changed:
        _state.due.add(FIELD)
    _state.changed.clear()
    if FIELD in _state.due:
        return POLL if _start(context, ob, FIELD, find_field) else None
    if not _state.due:
        return None
    if _state.drawn is not None or time.monotonic() - _state.last_change < REST:
        return WAIT
    if JUDGE in _state.due:
        return POLL if _start(context, ob, JUDGE, judge) else None
    _state.due.discard(GRAPH)
    session = sessions.session_of(ob)
    if getattr(context.scene, names.PROPERTIES).live_graph and not session.is_fresh("graph"):
        if session.is_fresh("time"):
            return POLL if _start(context, ob, GRAPH, build) else None
    return None


def _begin_with(ob):
    """Another object than before: all is to be found out."""
    if shown(ob) is None:
        shown_field.forget()
    key = compat.object_key(ob)
    _state.key, _state.inputs, _state.drawn = key, None, None
    _state.last_change = time.monotonic()
    _state.changed, _state.due = {sessions.ALL}, {FIELD, JUDGE, GRAPH}


def _forget():
    shown_field.forget()
    _state.key, _state.inputs, _state.drawn = None, None, None
    _state.changed.clear()
    _state.due.clear()


def _start(context, ob, kind, work):
    """-> False if the object cannot be read."""
    global _work
    try:
        library = native.load()
        if _state.inputs is None:
            model, settings = sessions.read_as_it_is(context, ob)
            _state.inputs = (model, settings, ob.matrix_world.copy())
        sessions.session_of(ob).unreadable = ""
    except (native.NativeMissing, UsageError) as error:
        sessions.session_of(ob).lose_sight(str(error))
        sessions.redraw(context)
        _state.due.clear()
        return False
    model, settings, matrix = _state.inputs
    if _state.drawn is not None and len(model.vertices) == len(ob.data.vertices):
        chain = Constraint("Chain", *_state.drawn)
        model = replace(model, constraints=(*model.constraints, chain))
    known = dict(sessions.session_of(ob).results)
    before = shown(ob).live if shown(ob) is not None else None
    _state.due.discard(kind)
    more = (library.FirstRows(),) if kind == GRAPH else ()
    job = Job(
        lambda run: work(library, model, settings, run, known, before, *more),
        library.RunContext(),
    )
    _work = _Work(
        kind, compat.object_key(ob), job, model, settings, matrix, time.monotonic(), *more
    )
    return True


def _while_working(context, ob):
    if ob is None or compat.object_key(ob) != _work.key:
        return
    if _work.first_rows is not None:
        first_rows.show(context, ob, _work)
    if _work.kind != FIELD:
        if sessions.TIMES in _state.changed:
            shown_field.follow(context, ob)
        sessions.redraw_sidebars(context)
    elif time.monotonic() - _work.began > PATIENCE:
        shown_field.grey(context, ob)


def _end_work(context, ob):
    """Publishes what a job found, if it is still about the active object as it is."""
    global _work
    work, _work = _work, None
    if work.first_rows is not None and ob is not None and compat.object_key(ob) == work.key:
        sessions.session_of(ob).show_first_rows(None)
    if work.job.error:
        raise RuntimeError(work.job.error)
    gone = ob is None or compat.object_key(ob) != work.key or work.job.value is None
    if gone or (work.kind != FIELD and (_state.changed or FIELD in _state.due)):
        _state.due.add(work.kind)
        return
    _PUBLISH[work.kind](context, ob, work)
    sessions.redraw(context)


def _publish_field(context, ob, work):
    live, outcome = work.job.value
    if outcome.status != "cancelled":
        sessions.session_of(ob).keep(outcome)
        _adopt(context, ob, live, work)
        _state.due.update((JUDGE, GRAPH))


def _adopt(context, ob, live, work):
    if not shown_field.adopt(context, ob, live, work.matrix):
        _state.changed.add(sessions.ALL)


def _publish_judgement(context, ob, work):
    live, guidance, outcome = work.job.value
    if guidance is None:
        return
    session = sessions.session_of(ob)
    session.keep(outcome)
    session.guidance = guidance
    sessions.seen(ob)
    _adopt(context, ob, live, work)
    _state.due.add(GRAPH)


def _publish_graph(_context, ob, work):
    outcome = work.job.value
    report = build_report(native.load(), work.model, work.settings, outcome)
    sessions.session_of(ob).adopt(outcome, report)


_PUBLISH = {FIELD: _publish_field, JUDGE: _publish_judgement, GRAPH: _publish_graph}


def _on_touch(ob, what):
    if active_mesh(bpy.context) != ob or not sessions.is_wanted(ob):
        return
    _state.changed.add(what)
    _state.due.update((JUDGE, GRAPH))
    _state.last_change = time.monotonic()
    _wake()


def _wake():
    # In background nobody looks on; tests and scripts call tick() themselves.
    if not bpy.app.background and not bpy.app.timers.is_registered(tick):
        bpy.app.timers.register(tick, first_interval=0.0)


@persistent
def _before_load(_):
    stop()


@persistent
def _after_load(_):
    _forget()
    _wake()


def register():
    sessions.listen(_on_touch)
    bpy.app.handlers.load_pre.append(_before_load)
    bpy.app.handlers.load_post.append(_after_load)


def unregister():
    stop()
    _forget()
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)
    bpy.app.handlers.load_post.remove(_after_load)
    bpy.app.handlers.load_pre.remove(_before_load)
    sessions.end_listening(_on_touch)
