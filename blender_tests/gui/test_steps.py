"""A person clicks through the steps of the panel."""

import time

import bpy
import meshknit
import numpy as np

from meshknit.scene import sessions
from user import pump, pump_until

KNIT = bpy.ops.meshknit


def session():
    return sessions.known_session(bpy.context.object)


def finished():
    return sessions.job() is None


def test_from_sock_to_machine_file_by_clicks(user, run, tmp_path):
    run(KNIT.add_sock)
    run(bpy.ops.view3d.view_selected)
    path = tmp_path / "sock.k"
    bpy.context.scene.meshknit.output = str(path)
    for call, stage in (
        ("meshknit.check_mesh(", "check"),
        ("meshknit.solve_time(", "time"),
        ("meshknit.build_graph(", "graph"),
        ("meshknit.schedule(", "schedule"),
    ):
        user.click_button(call)
        pump_until(lambda: finished() and session() and session().is_fresh(stage))
        assert not path.exists()
    user.click_button("meshknit.write_knitout(")
    pump_until(lambda: finished() and path.exists())
    assert path.read_text().startswith(";!knitout-2")
    report = session().report
    assert report["check"]["ok"] and report["graph"]["short_rows"] > 0
    pump(4)
    assert session().stale_stages() == []
    times = bpy.context.object.data.attributes["knit_time"].data
    values = np.array([entry.value for entry in times])
    assert values.min() == -1.0 and values.max() == 1.0


def test_the_window_stays_alive_and_esc_cancels(user, run):
    run(KNIT.add_sock)
    scene = bpy.context.scene.meshknit
    scene.stitch_width, scene.stitch_height = 0.6, 0.3  # fine: half a minute of work
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: sessions.job() is not None)
    job, seen = sessions.job(), []
    while len(seen) < 8 and job.running:
        seen.append(job.progress)
        pump(2)
    assert len(seen) == 8  # Blender drew eight times while the library worked
    assert seen == sorted(seen)
    assert not KNIT.solve_time.poll()  # one step at a time
    user.over_view()
    user.press("ESC")
    pump_until(finished)
    assert job.value.status == "cancelled"
    assert session() is None or session().value("graph") is None
    assert KNIT.solve_time.poll()


def test_the_panels_cancel_button(user, run):
    run(KNIT.add_sock)
    scene = bpy.context.scene.meshknit
    scene.stitch_width, scene.stitch_height = 0.6, 0.3
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: sessions.job() is not None)
    job = sessions.job()
    user.click_button("meshknit.cancel(")
    pump_until(finished)
    assert job.value.status == "cancelled"


def test_solving_time_is_one_undo_step(user, tube):
    user.click_button("meshknit.solve_time(")
    pump_until(lambda: finished() and "knit_time" in bpy.context.object.data.attributes)
    user.over_view()
    user.press("Z", ctrl=True)
    assert "knit_time" not in bpy.context.object.data.attributes
    assert len(bpy.context.object.data.meshknit.constraints) == 2
    user.press("Z", ctrl=True, shift=True)
    assert "knit_time" in bpy.context.object.data.attributes


def test_a_problem_is_shown_by_its_button(user, tube):
    KNIT.remove_constraint(index=1)
    user.click_button("meshknit.solve_time(")
    pump_until(lambda: finished() and session() is not None and session().problems)
    codes = [p["code"] for p in session().problems]
    user.click_button(f"meshknit.select_problem(index={codes.index('boundary-without-time')})")
    ob = bpy.context.object
    assert ob.mode == "EDIT"
    ob.update_from_editmode()
    chosen = [v.co.z for v in ob.data.vertices if v.select]
    assert chosen and min(chosen) > 0.059  # the upper rim, of a tube 60 mm high


def test_a_boundary_gets_its_time_back_by_a_click(user, tube):
    KNIT.remove_constraint(index=0)
    user.click_button("meshknit.add_boundary_constraint(")
    times = [round(c.time, 3) for c in bpy.context.object.data.meshknit.constraints]
    assert times == [1.0, -1.0]


def test_selected_edges_in_edit_mode_become_a_constraint(user, run, tube):
    user.over_view()
    user.press("TAB")
    pump_until(lambda: bpy.context.object.mode == "EDIT")
    run(bpy.ops.mesh.select_all, action="DESELECT")
    run(bpy.ops.mesh.select_non_manifold)
    user.click_button("meshknit.add_time_constraint(")
    pump(4)
    # Both rims are selected: that is not one chain.
    assert len(bpy.context.object.data.meshknit.constraints) == 2
    run(bpy.ops.mesh.select_all, action="DESELECT")
    KNIT.select_constraint(index=0)
    user.click_button("meshknit.add_time_constraint(")
    # The edges go over to a new constraint, and the one that had them is gone.
    settings = bpy.context.object.data.meshknit
    pump_until(lambda: [c.name for c in settings.constraints] == ["End", "Constraint 3"])


def test_a_changed_time_greys_the_results_by_itself(user, tube):
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: finished() and session() and session().is_fresh("graph"))
    pump(10)
    bpy.context.object.data.meshknit.constraints[0].time = -0.5
    pump_until(lambda: "graph" in session().stale_stages(), seconds=20)
    bpy.context.object.data.meshknit.constraints[0].time = -1.0
    pump_until(lambda: session().stale_stages() == [], seconds=20)


def test_at_rest_the_object_is_not_looked_at_again_and_again(user, tube, monkeypatch):
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: finished() and session() and session().is_fresh("graph"))
    end = time.monotonic() + 3 * sessions.SECONDS_OF_REST
    pump_until(lambda: time.monotonic() > end)
    looks = []
    monkeypatch.setattr(sessions, "look_again", lambda *_: looks.append(1))
    end = time.monotonic() + 3 * sessions.SECONDS_OF_REST
    pump_until(lambda: time.monotonic() > end)
    assert looks == []


def test_an_object_in_sculpt_mode_is_looked_at_only_after_it(user, tube, monkeypatch):
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: finished() and session() and session().is_fresh("graph"))
    looks, read = [], sessions.read_as_it_is
    monkeypatch.setattr(
        sessions, "read_as_it_is", lambda *a: (looks.append(a[1].mode), read(*a))[1]
    )
    for mode in ("SCULPT", "EDIT", "WEIGHT_PAINT"):
        bpy.ops.object.mode_set(mode=mode)
        looks.clear()
        bpy.context.object.data.meshknit.constraints[0].time = -0.5
        end = time.monotonic() + 3 * sessions.SECONDS_OF_REST
        pump_until(lambda: time.monotonic() > end)
        assert looks == [] and bpy.context.object.mode == mode
    assert "graph" in session().stale_stages()  # which needs no look
    bpy.ops.object.mode_set(mode="OBJECT")
    pump_until(lambda: session().is_fresh("graph"), seconds=20)
    assert set(looks) == {"OBJECT"}


def test_disabling_the_add_on_ends_a_running_step(user, tube):
    scene = bpy.context.scene.meshknit
    scene.stitch_width, scene.stitch_height = 0.3, 0.15
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: sessions.job() is not None)
    job = sessions.job()
    meshknit.unregister()
    meshknit.register()
    pump(10)
    assert sessions.job() is None and not job.running
    assert KNIT.build_graph.poll()


def test_the_status_bar_is_free_after_a_change_of_workspace(user, tube):
    from bl_ui.space_statusbar import STATUSBAR_HT_header

    plain = STATUSBAR_HT_header.draw
    scene = bpy.context.scene.meshknit
    scene.stitch_width, scene.stitch_height = 0.3, 0.15
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: STATUSBAR_HT_header.draw is not plain)
    job = sessions.job()
    first, other = bpy.data.workspaces["Layout"], bpy.data.workspaces["Modeling"]
    user.window.workspace = other
    pump(4)
    job.cancel()
    pump_until(finished)
    assert STATUSBAR_HT_header.draw is plain
    user.window.workspace = first
    pump(4)


def test_loading_a_file_ends_a_running_step(user, tube):
    scene = bpy.context.scene.meshknit
    scene.stitch_width, scene.stitch_height = 0.3, 0.15
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: sessions.job() is not None)
    job = sessions.job()
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    pump_until(lambda: sessions.job() is None and not job.running)
    assert job.value.status == "cancelled"
    # Nothing of the old file is asked for again: its windows are gone, too.
    KNIT.add_straight_tube()
    assert KNIT.check_mesh() == {"FINISHED"}
