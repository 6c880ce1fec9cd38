"""The sessions of the objects of this Blender, and the one job that may run.

Results live in memory only. What must survive saving and undo is on the mesh."""

import bpy
from bpy.app.handlers import persistent

from .. import compat, names
from ..core.errors import UsageError
from ..core.session import Session
from ..core.workflow import stage_keys
from .edit_mode import object_mode
from .read_model import read_model
from .settings_io import read_settings

# What may have changed about an object.
ALL, PLACE, TIMES = "ALL", "PLACE", "TIMES"

SECONDS_OF_REST = 0.4  # how long nothing may change before an object is looked at again

_sessions = {}
_touched = set()
_revisions = {}  # of every object's mesh, for drawing
_unit_scale = None  # of the scene, as last seen
_job = None
_expected = set()  # objects of whose changed times Blender will tell as of a changed mesh
_listeners = []  # called with every touched object and what may have changed


def session_of(ob):
    """The object's session; made when first asked for."""
    return _sessions.setdefault(compat.object_key(ob), Session())


def known_session(ob):
    """The object's session, or None if it has none yet. For drawing."""
    return _sessions.get(compat.object_key(ob)) if ob is not None else None


def object_of(scene, key):
    """The object of a scene that has this key (compat.object_key), or None."""
    return next((ob for ob in scene.objects if compat.object_key(ob) == key), None)


def finding(ob, index):
    """-> (problem, session): one of the problems of the guidance. Throws UsageError."""
    session = session_of(ob)
    if not session.is_guidance_fresh():
        raise UsageError("The object has changed since: wait for the new guidance")
    if index >= len(session.guidance.problems):
        raise UsageError(f"There is no finding {index}")
    return session.guidance.problems[index], session


def job():
    """The running job or None."""
    return _job


def set_job(running):
    global _job
    _job = running


def read_inputs(context, ob):
    """-> (model, settings) of the active object, in any mode. For operators, which may change the
    mode. Throws UsageError."""
    with object_mode(ob):
        return read_as_it_is(context, ob)


def is_wanted(ob):
    """True for objects that someone means to knit: others are left in peace."""
    settings = getattr(ob.data, names.PROPERTIES)
    marked = settings.constraints or settings.openings or settings.time_source != "CONSTRAINTS"
    return bool(marked) or known_session(ob) is not None


def read_as_it_is(context, ob):
    """-> (model, settings) of an object. Requires Object Mode. Throws UsageError."""
    context.view_layer.update()
    model = read_model(ob, context.evaluated_depsgraph_get(), context.scene)
    return model, read_settings(context.scene)


def look_again(context, ob):
    """Compares the object with its results, so that stale ones are shown as such. Requires Object
    Mode: it runs at any moment, when changing the mode could end what a person does.
    -> (model, settings), or None if there are no results or the settings are wrong"""
    _touched.discard(compat.object_key(ob))
    session = known_session(ob)
    if session is None or not session.results:
        return None
    try:
        model, settings = read_as_it_is(context, ob)
        session.look_at(stage_keys(model, settings))
        session.unreadable = ""
        return model, settings
    except UsageError as error:
        session.lose_sight(str(error))
        return None


def mesh_revision(ob):
    """A number that grows with every change of the object's mesh. For drawing."""
    return _revisions.get(compat.object_key(ob), 0)


def listen(listener):
    """From now on listener(ob, what) is called for every touched object."""
    _listeners.append(listener)


def end_listening(listener):
    _listeners.remove(listener)


def touch(ob, what=ALL):
    """Says that an object may have changed, or at most its transform (PLACE) or the times of its
    marks (TIMES). In the GUI it is looked at again after a moment."""
    if what != TIMES:
        _revisions[compat.object_key(ob)] = mesh_revision(ob) + 1
    for listener in _listeners:
        listener(ob, what)
    session = known_session(ob)
    if session is None or not session.results:
        return
    _touched.add(compat.object_key(ob))
    if not bpy.app.background:
        if bpy.app.timers.is_registered(_look_at_touched):
            bpy.app.timers.unregister(_look_at_touched)
        bpy.app.timers.register(_look_at_touched, first_interval=SECONDS_OF_REST)


def seen(ob):
    """Says that an object was compared with its results just now."""
    _touched.discard(compat.object_key(ob))


def touch_users(data, context, what=ALL):
    """For properties: touches the objects that show a mesh, or all for a scene's property."""
    for ob in context.scene.objects:
        if ob.type == "MESH" and (ob.data == data or data == context.scene):
            if what == TIMES:
                _expected.add(compat.object_key(ob))
            touch(ob, what)


def _look_at_touched():
    context = bpy.context
    waiting = [ob for ob in context.scene.objects if compat.object_key(ob) in _touched]
    active = context.view_layer.objects.active
    at_work = [ob for ob in (active, *waiting) if ob is not None and ob.mode != "OBJECT"]
    # While a person edits, paints or sculpts, perhaps in mid-stroke, the look waits.
    if _job is not None or at_work:
        return SECONDS_OF_REST
    for ob in waiting:
        look_again(context, ob)
    redraw(context)
    return None


def redraw(context):
    """Redraws the 3D views of all windows."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def redraw_sidebars(context):
    """Redraws the panels of the 3D views, which is cheap."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                for region in area.regions:
                    if region.type == "UI":
                        region.tag_redraw()


@persistent
def _after_load(_):
    _sessions.clear()
    _touched.clear()
    _expected.clear()
    # Not back to 0: a drawing of the file before must not pass for one of this file.
    for key in _revisions:
        _revisions[key] += 1


@persistent
def _after_undo(scene, _depsgraph=None):
    _touch_all(scene)


def _touch_all(scene):
    for ob in scene.objects:
        if ob.type == "MESH":
            touch(ob)


@persistent
def _after_change(scene, depsgraph):
    global _unit_scale
    if scene.unit_settings.scale_length != _unit_scale:
        _unit_scale = scene.unit_settings.scale_length
        _touch_all(scene)
    for update in depsgraph.updates:
        if update.is_updated_geometry or update.is_updated_transform:
            ob = update.id.original
            if isinstance(ob, bpy.types.Object) and ob.type == "MESH":
                touch(ob, _what_changed(ob, update))


def _what_changed(ob, update):
    if not update.is_updated_geometry:
        return PLACE
    expected = compat.object_key(ob) in _expected
    _expected.discard(compat.object_key(ob))
    return TIMES if expected and not update.is_updated_transform else ALL


_HANDLERS = (
    ("load_post", _after_load),
    ("undo_post", _after_undo),
    ("redo_post", _after_undo),
    ("depsgraph_update_post", _after_change),
)


def register():
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    if bpy.app.timers.is_registered(_look_at_touched):
        bpy.app.timers.unregister(_look_at_touched)
    _after_load(None)
