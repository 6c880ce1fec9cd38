"""A person drags a time, and the view follows."""

import time

import bpy
import numpy as np

from meshknit.scene import live, sessions
from meshknit.scene.shown_field import shown
from pictures import count, show
from user import pump, pump_until

KNIT = bpy.ops.meshknit


def session():
    return sessions.known_session(bpy.context.object)


def is_at_rest():
    return live.progress() is None and not bpy.app.timers.is_registered(live.tick)


def test_a_dragged_value_changes_the_colours_while_it_is_dragged(user, run, tube, picture):
    show(user, show_graph=False)
    run(bpy.ops.view3d.view_axis, type="FRONT")
    pump_until(is_at_rest)
    before = picture()
    assert count(before, "blue") > 200 and count(before, "red") > 200
    x, y = user.find_field("constraints[0].time", fraction=0.55)
    user.move(user.sidebar, x, y)
    user.event("LEFTMOUSE", "PRESS")
    value, step, greyed = -1.0, 0, False
    while value < -0.3 and step < 40:
        step += 1
        user.move(user.sidebar, x + 4 * step, y)
        value = bpy.context.object.data.meshknit.constraints[0].time
        greyed = greyed or "graph" in session().stale_stages()
    assert greyed  # the graph of before is not passed off as one for these times
    assert -0.3 <= value < 0.9  # the start is later now, with the button still held
    pump_until(lambda: abs(shown(bpy.context.object).times.min() - value) < 1e-6, seconds=5)
    during = picture()
    user.event("LEFTMOUSE", "RELEASE")
    assert count(during, "blue") < 0.8 * count(before, "blue")
    pump_until(is_at_rest)
    assert session().is_fresh("graph") and session().is_guidance_fresh()


def test_there_is_a_line_where_each_row_will_lie(user, run, tube, picture):
    show(user, show_graph=False)
    run(bpy.ops.view3d.view_axis, type="FRONT")
    pump_until(is_at_rest)
    seen = picture()
    column = seen[:, seen.shape[1] // 2 + 40].mean(axis=1)
    coloured = np.flatnonzero(np.ptp(seen[:, seen.shape[1] // 2 + 40], axis=1) > 0.2)
    column = column[coloured.min() : coloured.max()]
    # A line is darker than what is two pixels above and below it.
    dark = (column[4:-4] < column[:-8] - 0.06) & (column[4:-4] < column[8:] - 0.06)
    lines = int((np.diff(np.concatenate([[0], dark.astype(int)])) == 1).sum())
    # 60 mm in rows of 3.46 mm.
    assert abs(lines - 17) <= 2


def test_the_window_stays_alive_while_a_large_mesh_is_prepared(user, run):
    run(
        bpy.ops.mesh.primitive_uv_sphere_add,
        segments=400,
        ring_count=250,
        radius=0.05,
    )
    KNIT.add_opening(location=(0.0, 0.0, -0.05), radius=10.0, time=-1.0)
    KNIT.add_opening(location=(0.0, 0.0, 0.05), radius=10.0, time=1.0)
    bpy.context.scene.meshknit.live_graph = False
    turns, longest, last = 0, 0.0, time.monotonic()
    end = last + 60.0
    while shown(bpy.context.object) is None:
        pump()
        now = time.monotonic()
        longest, last, turns = max(longest, now - last), now, turns + 1
        assert now < end
    # The surface and the field of 200,000 triangles take seconds; no turn of Blender's own loop may.
    assert turns > 5 and longest < 2.0
    pump_until(is_at_rest, seconds=60.0)
    assert session().is_guidance_fresh()


def test_suggest_runs_in_the_background_and_can_be_cancelled(user, run):
    run(bpy.ops.meshknit.add_teddy)
    run(bpy.ops.ed.undo_push, message="teddy")
    mesh = bpy.context.object.data
    pump_until(is_at_rest)
    before = [tuple(o.location) for o in mesh.meshknit.openings]
    with bpy.context.temp_override(window=user.window, area=user.area, region=user.view):
        KNIT.suggest("INVOKE_DEFAULT")
    assert sessions.job() is not None
    user.over_view()
    user.press("ESC")
    pump_until(lambda: sessions.job() is None)
    assert [tuple(o.location) for o in mesh.meshknit.openings] == before
    user.click_button("meshknit.suggest(")
    pump_until(lambda: sessions.job() is None and session().suggestions is not None)
    after = [tuple(o.location) for o in bpy.context.object.data.meshknit.openings]
    assert after != before and len(after) >= 2
    user.over_view()
    user.press("Z", ctrl=True)
    assert [tuple(o.location) for o in bpy.context.object.data.meshknit.openings] == before


def test_first_rows_are_drawn_while_a_large_graph_is_made(user, run):
    run(bpy.ops.meshknit.add_trousers)
    ob = bpy.context.object
    ob.data.meshknit.size_mode, ob.data.meshknit.size = "SIZE", 800.0
    known = sessions.session_of(ob)
    pump_until(lambda: known.first_rows is not None)
    rows, _ = known.first_rows
    pump(4)
    pump_until(lambda: known.is_fresh("graph"))
    assert 0 < len(rows.nodes) < len(known.value("graph").nodes)
    assert known.first_rows is None
