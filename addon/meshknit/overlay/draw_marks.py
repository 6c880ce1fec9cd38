"""Draws constraints, openings that are not cut yet, and what a person is drawing."""

import bpy
import numpy as np

from .. import compat
from ..core import colors
from ..scene import sessions
from ..scene.active_tool import is_tool_active
from ..scene.canvas import canvas_of, forget
from ..scene.mark_lists import CONSTRAINTS, OPENINGS, selected_mark
from ..scene.opening_rings import surface_of, world_rings
from ..scene.pointing import Pointer
from . import stroke
from .batches import cached, draw_batch, new_thick_lines, thick_shader
from .overlay_data import chain_lines, in_color, marked_lines, ring_lines
from .shown import LIFT, active_object, free_room, has_fresh_rims, is_within, stitch_height
from .text import draw_label

THIN, EDGE, WIDE = 3.0, 6.0, 7.0  # pixels

_handles = []


def _draw_view():
    ob, shown = active_object()
    context = bpy.context
    depsgraph = context.view_layer.depsgraph
    if ob is None or ob.mode not in ("OBJECT", "EDIT") or depsgraph is None:
        return
    at_work = is_tool_active(context)
    session = sessions.known_session(ob)
    # Without the tool, Edit Mode is for modelling: reading a mesh in mid-edit would slow it down.
    if at_work or stroke.shown() is not None or (ob.mode == "OBJECT" and shown.show_time):
        import gpu

        gpu.state.blend_set("ALPHA")
        gpu.state.depth_test_set("LESS_EQUAL")
        lift = LIFT * stitch_height(session, shown, "check")
        batches = _mark_batches(ob, depsgraph, not has_fresh_rims(session))
        chosen = selected_mark(ob.data) if at_work else None
        _draw_chains(batches, chosen, lift)
        _draw_rings(batches, chosen, lift)
        _draw_stroke(lift)
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("NONE")


def _mark_batches(ob, depsgraph, with_rings):
    """-> {what: batch}: all chains, their edges, and each chain and ring that may be selected."""
    times = [round(entry.time, 4) for entry in CONSTRAINTS.entries(ob.data)]
    key = (compat.object_key(ob), sessions.mesh_revision(ob), ob.mode, with_rings, tuple(times))

    def make():
        canvas = canvas_of(ob, depsgraph)
        known = canvas.segment_marks <= len(times)
        segments, marks = canvas.segments[known], canvas.segment_marks[known]
        lines = marked_lines(segments, marks, times)
        made = {"chains": lines, "edges": in_color(lines, colors.EDGE_OF_MARK)}
        for mark in np.unique(marks).tolist():
            own = marked_lines(segments[marks == mark], marks[marks == mark], times)
            made["CONSTRAINT", mark - 1] = in_color(own, colors.SELECTED)
        rings = _rings(ob, depsgraph, canvas) if with_rings else []
        made["rings"] = ring_lines([ring for _, ring in rings])
        for index, ring in rings:
            made["OPENING", index] = in_color(ring_lines([ring]), colors.SELECTED)
        return {what: new_thick_lines(lines) for what, lines in made.items()}

    return cached("marks", key, make)


def _rings(ob, depsgraph, canvas):
    if not any(entry.number == 0 for entry in OPENINGS.entries(ob.data)):
        return []
    return world_rings(ob, canvas.surface(lambda: surface_of(ob, depsgraph)))


def _draw_chains(batches, chosen, lift):
    draw_batch(batches["edges"], 0.8 * lift, shader=thick_shader(EDGE))
    if chosen is not None and chosen[0] is CONSTRAINTS:
        draw_batch(batches.get(("CONSTRAINT", chosen[1])), 0.9 * lift, shader=thick_shader(WIDE))
    draw_batch(batches["chains"], lift, shader=thick_shader(THIN))


def _draw_rings(batches, chosen, lift):
    if chosen is not None and chosen[0] is OPENINGS:
        draw_batch(batches.get(("OPENING", chosen[1])), 0.9 * lift, shader=thick_shader(WIDE))
    draw_batch(batches["rings"], lift, shader=thick_shader(THIN))


def _draw_stroke(lift):
    shown = stroke.shown()
    if shown is None:
        return
    shade = colors.RIM if shown.time is None else colors.time_colors([shown.time])[0]
    lines = chain_lines(shown.points, shade)
    batch = new_thick_lines(in_color(lines, colors.SELECTED))
    draw_batch(batch, 1.1 * lift, shader=thick_shader(WIDE))
    draw_batch(new_thick_lines(lines), 1.2 * lift, shader=thick_shader(THIN + 1.0))


def _draw_times():
    """The time of every constraint, beside it."""
    ob, _ = active_object()
    context = bpy.context
    depsgraph = context.view_layer.depsgraph
    at_rest = stroke.shown() is None and depsgraph is not None
    if ob is None or not is_tool_active(context) or not at_rest:
        return
    canvas = canvas_of(ob, depsgraph)
    pointer, room = Pointer(context, ob, canvas, (0, 0)), free_room()
    for index, entry in enumerate(CONSTRAINTS.entries(ob.data)):
        rows = np.flatnonzero(canvas.segment_marks == index + 1)
        pixel = _first_visible(pointer, canvas.segments[rows], room)
        if pixel is not None:
            draw_label(pixel[0] + 10, pixel[1] + 8, [f"{entry.time:.3g}"], room)


def _first_visible(pointer, segments, room, tries=5):
    """Pixels of the middle of a segment that is in sight and within the room, of a few along the
    chain."""
    for row in np.linspace(0, len(segments) - 1, min(tries, len(segments))).astype(int):
        middle = segments[row].mean(axis=0)
        pixel = pointer.pixel(middle)
        if pixel is None or not is_within(pixel, room):
            continue
        if pointer.is_visible(middle, np.linalg.norm(segments[row][1] - segments[row][0])):
            return pixel
    return None


def register():
    if bpy.app.background:
        return
    view = bpy.types.SpaceView3D
    _handles.append(view.draw_handler_add(_draw_view, (), "WINDOW", "POST_VIEW"))
    _handles.append(view.draw_handler_add(_draw_times, (), "WINDOW", "POST_PIXEL"))


def unregister():
    for handle in _handles:
        bpy.types.SpaceView3D.draw_handler_remove(handle, "WINDOW")
    _handles.clear()
    stroke.clear()
    forget()
