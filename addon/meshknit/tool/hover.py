"""What a click would do, beside the mouse: drawn over the 3D view while the tool is active."""

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import names
from ..overlay import stroke
from ..overlay.text import draw_dot, draw_label, draw_lines
from ..scene import sessions
from ..scene.active_tool import is_tool_active
from ..scene.canvas import canvas_of
from ..scene.mark_lists import CONSTRAINTS, OPENINGS
from ..scene.pointing import Pointer
from . import status

_handles = []


def _draw(mouse):
    context = bpy.context
    if context.region is None or context.region_data is None:
        return
    status.follow(context)
    if not is_tool_active(context):
        return
    ob, depsgraph = context.view_layer.objects.active, context.view_layer.depsgraph
    busy = stroke.shown() is not None or sessions.job() is not None or depsgraph is None
    if ob is None or ob.type != "MESH" or not ob.visible_get() or busy:
        return
    x, y = mouse[0] - context.region.x, mouse[1] - context.region.y
    canvas = canvas_of(ob, depsgraph)
    pointer = Pointer(context, ob, canvas, (x, y))
    target = pointer.target()
    rim = pointer.rim()
    lines = describe(ob, pointer, target, rim)
    if not lines:
        return
    import gpu

    with gpu.matrix.push_pop():
        # A cursor's pixels are those of the window.
        gpu.matrix.translate((context.region.x, context.region.y, 0.0))
        _highlight(canvas, pointer, target)
        draw_label(x + 18, y - 40, lines, (context.region.width, context.region.height))


def describe(ob, pointer, target, rim=None):
    """The lines of text beside the mouse, from the top."""
    lines = []
    if target is not None and target.hit is not None:
        time = pointer.time(target.hit)
        if time is not None:
            lines.append(f"Time {time:.2f}" + ("" if _is_fresh(ob) else " (of an earlier state)"))
    if target is not None:
        lines += _actions(ob, target)
    if rim is not None:
        lines.append("C: whole boundary")
    return lines


def _actions(ob, target):
    if target.kind == "MODIFIED":
        return [names.MADE_BY_MODIFIER]
    if target.kind == "SURFACE":
        return ["Drag: lay a constraint"]
    marks = OPENINGS if target.kind == "OPENING" else CONSTRAINTS
    entries = marks.entries(ob.data)
    if target.index >= len(entries):
        return []
    entry = entries[target.index]
    time = f"{entry.time:.3g}" if marks is CONSTRAINTS or entry.has_time else "no time"
    lines = [f"{entry.name}: {time}", "Click: select"]
    if target.kind == "END":
        lines.append("Drag: go on with it")
    return lines


def _is_fresh(ob):
    """True if the field is the one of the marks as they are."""
    if getattr(ob.data, names.PROPERTIES).time_source == "ATTRIBUTE":
        return True
    session = sessions.known_session(ob)
    return session is not None and session.is_fresh("time")


def _highlight(canvas, pointer, target):
    if target is None:
        return
    if target.kind in ("END", "CONSTRAINT"):
        rows = np.flatnonzero(canvas.segment_marks == target.index + 1)
        pairs = [[pointer.pixel(end) for end in canvas.segments[row]] for row in rows]
        draw_lines([pair for pair in pairs if None not in pair])
    if target.vertex is not None and target.kind != "OPENING":
        pixel = pointer.pixel(pointer.shown_places([target.vertex])[0])
        if pixel is not None:
            draw_dot(*pixel)


@persistent
def _begin(_=None):
    """Blender keeps such drawings with the window manager, and a file may bring another."""
    _end()
    manager = bpy.types.WindowManager
    _handles.append(manager.draw_cursor_add(lambda mouse: _draw(mouse), (), "VIEW_3D", "WINDOW"))


def _end():
    while _handles:
        bpy.types.WindowManager.draw_cursor_remove(_handles.pop())


def register():
    _begin()
    bpy.app.handlers.load_post.append(_begin)


def unregister():
    bpy.app.handlers.load_post.remove(_begin)
    _end()
