"""Draws the overlay into the 3D views. Touches the GPU in the GUI only."""

import bpy

from .. import compat, names
from ..core.colors import time_colors
from ..scene import sessions, shown_field
from ..scene.read_overlay import read_time_surface
from . import batches, overlay_data
from .batches import cached, draw_batch, new_batch, new_thick_lines, thick_shader
from .draw_field import draw_field
from .shown import LIFT, active_object, has_fresh_rims, is_cut, size_of_region, stitch_height
from .text import draw_plate

THICKNESS = 2.5  # pixels, of short rows and shaping
LEGEND_SHADE = (0.85, 0.85, 0.85, 0.85)
# Pixels at scale 1; texts begin LEGEND_TEXT beside their lines.
LEGEND_LEFT, LEGEND_BOTTOM, LEGEND_STEP, LEGEND_SIZE, LEGEND_TEXT, LEGEND_FRAME = (
    18,
    18,
    18,
    12,
    36,
    8,
)

_handles = []


def _draw_view():
    ob, shown = active_object()
    if ob is None:
        return
    import gpu

    session = sessions.known_session(ob)
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("LESS_EQUAL")
    if shown.show_time and ob.mode == "OBJECT":
        lift = 0.3 * LIFT * stitch_height(session, shown, "time")
        field = shown_field.shown(ob)
        if field is not None:
            # The graph's rows take the place of the lines where rows will be.
            built = shown.show_graph and session is not None and session.is_fresh("graph")
            draw_field(field, ob.matrix_world, lift, with_lines=not built)
        elif is_cut(session) and session.is_fresh("time"):
            draw_batch(_cut_batch(session), lift)
        else:
            draw_batch(_time_batch(ob, session), lift, ob.matrix_world)
    _draw_rims(session, shown)
    if shown.show_graph and session is not None and session.shown_graph() is not None:
        thin, thick = _graph_batches(session)
        lift = LIFT * stitch_height(session, shown, "check")
        draw_batch(thin, lift)
        draw_batch(thick, 1.2 * lift, shader=thick_shader(THICKNESS))
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _draw_rims(session, shown):
    """As they were cut; draw_marks.py draws where they will be."""
    if has_fresh_rims(session):
        lift = LIFT * stitch_height(session, shown, "check")
        draw_batch(_rim_batch(session), lift, shader=thick_shader(THICKNESS))


def _time_batch(ob, session):
    # A field of the user's own is always as it should be. One from a file is not known to be.
    own = getattr(ob.data, names.PROPERTIES).time_source == "ATTRIBUTE"
    stale = not own and (session is None or not session.is_fresh("time"))
    signature = (compat.object_key(ob), sessions.mesh_revision(ob), stale)

    def make():
        surface = read_time_surface(ob, bpy.context.evaluated_depsgraph_get())
        if surface is None:
            return None
        triangles = overlay_data.time_triangles(*surface, stale)
        content = {"pos": triangles.points, "color": triangles.colors}
        return new_batch("TRIS", content, triangles.indices)

    return cached("time", signature, make)


def _cut_batch(session):
    """The field on what is left of the surface, in world space."""

    def make():
        knit, scale = session.value("check"), session.results["check"].scale
        shades = time_colors(session.value("time")[0])
        triangles = overlay_data.time_triangles(knit.cut.vertices / scale, shades, knit.cut.faces)
        content = {"pos": triangles.points, "color": triangles.colors}
        return new_batch("TRIS", content, triangles.indices)

    return cached("cut", session.drawing_key, make)


def _rim_batch(session):
    def make():
        knit, scale = session.value("check"), session.results["check"].scale
        rings = [knit.cut.vertices[list(rim.vertices)] / scale for rim in knit.rims]
        return new_thick_lines(overlay_data.ring_lines(rings))

    return cached("rims", session.drawing_key, make)


def _graph_batches(session):
    graph, scale, stale = session.shown_graph()
    signature = (session.drawing_key, stale)

    def make():
        thin, thick = overlay_data.graph_lines(graph, scale, stale)
        return (
            new_batch("LINES", {"pos": thin.points, "color": thin.colors}),
            new_thick_lines(thick),
        )

    return cached("graph", signature, make)


def _draw_legend():
    ob, shown = active_object()
    session = sessions.known_session(ob)
    if session is None or session.shown_graph() is None or not shown.show_graph:
        return
    import blf

    fresh = not session.shown_graph()[2]
    entries = overlay_data.LEGEND if fresh else (("column", "Knit graph of an earlier state"),)
    scale = bpy.context.preferences.system.ui_scale
    step = LEGEND_STEP * scale
    blf.size(0, LEGEND_SIZE * scale)
    width = LEGEND_TEXT * scale + max(blf.dimensions(0, text)[0] for _, text in entries)
    left = LEGEND_LEFT * scale + size_of_region("TOOLS")[0]
    # Blender's own panel for the last step has the same corner.
    bottom = LEGEND_BOTTOM * scale + size_of_region("HUD")[1]
    frame = LEGEND_FRAME * scale
    plate = (width + 2 * frame, (len(entries) - 1) * step + LEGEND_SIZE * scale + 2 * frame)
    draw_plate(left - frame, bottom - frame, *plate, LEGEND_SHADE)
    for line, (kind, text) in enumerate(reversed(entries)):
        y = bottom + line * step
        thickness = (1.0 if kind in ("row", "column") else THICKNESS) * scale
        length = (LEGEND_TEXT - 10) * scale
        draw_plate(left, y + 4 * scale, length, thickness, overlay_data.COLORS[kind])
        blf.position(0, left + LEGEND_TEXT * scale, y, 0)
        blf.color(0, 0.05, 0.05, 0.05, 1.0)
        blf.draw(0, text)


def register():
    if bpy.app.background:
        return
    view = bpy.types.SpaceView3D
    _handles.append(view.draw_handler_add(_draw_view, (), "WINDOW", "POST_VIEW"))
    _handles.append(view.draw_handler_add(_draw_legend, (), "WINDOW", "POST_PIXEL"))


def unregister():
    for handle in _handles:
        bpy.types.SpaceView3D.draw_handler_remove(handle, "WINDOW")
    _handles.clear()
    batches.forget()
