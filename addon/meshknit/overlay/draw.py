"""Draws the overlay into the 3D views. Touches the GPU in the GUI only."""

import bpy
from mathutils import Matrix

from .. import compat, names
from ..core.colors import time_colors
from ..scene import sessions
from ..scene.read_overlay import read_round_openings, read_time_surface
from . import overlay_data

LIFT = 0.35  # lines lie this many stitch heights nearer to the viewer than the surface
THICKNESS = 2.5  # pixels, of short rows and shaping
LEGEND_LEFT, LEGEND_BOTTOM, LEGEND_STEP, LEGEND_SIZE, LEGEND_WIDTH = 18, 18, 18, 12, 270

_handles = []
_batches = {}  # what -> (signature, batch or None)


def _draw_view():
    ob, shown = _active()
    if ob is None:
        return
    import gpu

    session = sessions.known_session(ob)
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("LESS_EQUAL")
    if shown.show_time and ob.mode == "OBJECT":
        lift = 0.3 * LIFT * _unit(session, shown, "time")
        if _is_cut(session) and session.is_fresh("time"):
            _draw_batch(_cut_batch(session), lift)
        else:
            _draw_batch(_time_batch(ob, session), lift, ob.matrix_world)
    _draw_rims(ob, session, shown)
    if shown.show_graph and session is not None and session.value("graph") is not None:
        thin, thick = _graph_batches(session)
        lift = LIFT * _unit(session, shown, "graph")
        _draw_batch(thin, lift)
        _draw_batch(thick, 1.2 * lift, shader=_thick_shader())
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _draw_rims(ob, session, shown):
    """As they were cut; before that, circles where they will be."""
    if _is_cut(session) and session.is_fresh("check"):
        lift = LIFT * _unit(session, shown, "check")
        _draw_batch(_rim_batch(session), lift, shader=_thick_shader())
    elif ob.mode == "OBJECT":
        lift = LIFT * _unit(session, shown, "check")
        _draw_batch(_circle_batch(ob), lift, ob.matrix_world, _thick_shader())


def _is_cut(session):
    return (
        session is not None
        and session.value("check") is not None
        and session.value("check").cut is not None
    )


def _draw_batch(batch, lift, matrix=None, shader=None):
    """Moves the drawing towards the viewer by `lift` scene units, so that the surface does not
    hide what lies on it."""
    if batch is None:
        return
    import gpu

    with gpu.matrix.push_pop():
        view = gpu.matrix.get_model_view_matrix()
        gpu.matrix.load_matrix(Matrix.Translation((0.0, 0.0, lift)) @ view)
        if matrix is not None:
            gpu.matrix.multiply_matrix(matrix)
        batch.draw(shader or gpu.shader.from_builtin("SMOOTH_COLOR"))


def _thick_shader():
    import gpu

    shader = gpu.shader.from_builtin("POLYLINE_SMOOTH_COLOR")
    region = bpy.context.region
    shader.bind()
    shader.uniform_float("viewportSize", (region.width, region.height))
    shader.uniform_float("lineWidth", THICKNESS)
    return shader


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
        return _new_batch("TRIS", content, triangles.indices)

    return _cached("time", signature, make)


def _cut_batch(session):
    """The field on what is left of the surface, in world space."""

    def make():
        knit, scale = session.value("check"), session.results["check"].scale
        shades = time_colors(session.value("time")[0])
        triangles = overlay_data.time_triangles(knit.cut.vertices / scale, shades, knit.cut.faces)
        content = {"pos": triangles.points, "color": triangles.colors}
        return _new_batch("TRIS", content, triangles.indices)

    return _cached("cut", session.drawing_key, make)


def _rim_batch(session):
    def make():
        knit, scale = session.value("check"), session.results["check"].scale
        rings = [knit.cut.vertices[list(rim.vertices)] / scale for rim in knit.rims]
        lines = overlay_data.ring_lines(rings)
        return _new_batch("LINES", {"pos": lines.points, "color": lines.colors}, None, "POLYLINE_")

    return _cached("rims", session.drawing_key, make)


def _circle_batch(ob):
    def make():
        rings = [overlay_data.circle(*place) for place in read_round_openings(ob)]
        lines = overlay_data.ring_lines(rings)
        return _new_batch("LINES", {"pos": lines.points, "color": lines.colors}, None, "POLYLINE_")

    return _cached("circles", (compat.object_key(ob), sessions.mesh_revision(ob)), make)


def _graph_batches(session):
    stale = not session.is_fresh("graph")
    signature = (session.drawing_key, stale)

    def make():
        graph = session.results["graph"]
        thin, thick = overlay_data.graph_lines(graph.value, graph.scale, stale)
        return (
            _new_batch("LINES", {"pos": thin.points, "color": thin.colors}),
            _new_batch("LINES", {"pos": thick.points, "color": thick.colors}, None, "POLYLINE_"),
        )

    return _cached("graph", signature, make)


def _cached(what, signature, make):
    held = _batches.get(what)
    if held is None or held[0] != signature:
        held = _batches[what] = (signature, make())
    return held[1]


def _new_batch(kind, content, indices=None, prefix=""):
    import gpu
    from gpu_extras.batch import batch_for_shader

    if not len(content["pos"]):
        return None
    shader = gpu.shader.from_builtin(prefix + "SMOOTH_COLOR")
    return batch_for_shader(shader, kind, content, indices=indices)


def _draw_legend():
    ob, shown = _active()
    session = sessions.known_session(ob)
    if session is None or session.value("graph") is None or not shown.show_graph:
        return
    import blf

    fresh = session.is_fresh("graph")
    entries = overlay_data.LEGEND if fresh else (("column", "Knit graph of an earlier state"),)
    left = LEGEND_LEFT + _width_of_toolbar()
    _draw_box(left - 8, LEGEND_BOTTOM - 8, LEGEND_WIDTH, len(entries) * LEGEND_STEP + 10)
    blf.size(0, LEGEND_SIZE)
    for line, (kind, text) in enumerate(reversed(entries)):
        blf.position(0, left, LEGEND_BOTTOM + line * LEGEND_STEP, 0)
        blf.color(0, *overlay_data.COLORS[kind])
        blf.draw(0, "\u2014\u2014")
        blf.position(0, left + 3 * LEGEND_SIZE, LEGEND_BOTTOM + line * LEGEND_STEP, 0)
        blf.color(0, 0.05, 0.05, 0.05, 1.0)
        blf.draw(0, text)


def _draw_box(left, bottom, width, height):
    import gpu
    from gpu_extras.batch import batch_for_shader

    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    right, top = left + width, bottom + height
    corners = [(left, bottom, 0), (right, bottom, 0), (right, top, 0), (left, top, 0)]
    batch = batch_for_shader(shader, "TRIS", {"pos": corners}, indices=[(0, 1, 2), (0, 2, 3)])
    gpu.state.blend_set("ALPHA")
    shader.bind()
    shader.uniform_float("color", (0.85, 0.85, 0.85, 0.85))
    batch.draw(shader)
    gpu.state.blend_set("NONE")


def _width_of_toolbar():
    return next((r.width for r in bpy.context.area.regions if r.type == "TOOLS"), 0)


def _active():
    """-> (active mesh object or None, the scene's properties); None where overlays are off."""
    context = bpy.context
    shown = getattr(context.scene, names.PROPERTIES)
    ob = context.object
    visible = context.space_data.overlay.show_overlays
    if ob is None or ob.type != "MESH" or not visible or not ob.visible_get():
        return None, shown
    return ob, shown


def _unit(session, shown, stage):
    """A stitch height in scene units, at the scale of a stage's own run."""
    result = session.results.get(stage) if session is not None else None
    return shown.stitch_height / (result.scale if result is not None else 1000.0)


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
    _batches.clear()
