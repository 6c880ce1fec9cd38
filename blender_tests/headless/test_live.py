"""The live field: it follows what a person changes, and never passes off the old for the new."""

import bpy
import numpy as np
import pytest

import meshes
from meshknit import native
from meshknit.core.workflow import run_stages
from meshknit.scene import live, sessions
from meshknit.scene.shapes import add_object
from meshknit.scene.shown_field import shown
from objects import add_mesh, session, settle

KNIT = bpy.ops.meshknit


def field():
    return shown(bpy.context.object)


def entries():
    return bpy.context.object.data.meshknit.constraints


def test_an_object_with_marks_gets_field_guidance_and_graph(tube):
    settle()
    assert (field().times.min(), field().times.max()) == (-1.0, 1.0)
    assert session().is_guidance_fresh() and session().is_fresh("graph")
    # 60 mm in rows of two courses of 1.73 mm each.
    assert field().rows.max() == pytest.approx(60.0 / 3.46, rel=0.01)


def test_a_dragged_time_is_one_back_solve_away(tube):
    settle()
    before = field()
    entries()[0].time = -0.5
    live.tick()
    assert field().times.min() == -0.5 and field().live is before.live
    # The graph of before is stale at once, and the new one follows by itself.
    assert "graph" in session().stale_stages() and not session().is_guidance_fresh()
    settle()
    assert session().stale_stages() == [] and session().value("time")[0].min() == -0.5


def test_times_that_come_back_need_no_new_graph(tube):
    settle()
    graph = session().value("graph")
    entries()[0].time = -0.5
    live.tick()
    entries()[0].time = -1.0
    settle()
    assert session().is_fresh("graph") and session().value("graph") is graph


def test_a_new_chain_gets_its_time(tube):
    settle()
    shape = field().live.shape
    places = [[0.02, 0.0, 0.02], [0.0, 0.02, 0.02]]
    KNIT.add_time_constraint(points=str(places), time=0.5)
    settle()
    at = np.argmin(((shape.places - places[0]) ** 2).sum(axis=1))
    assert field().times[at] == 0.5
    assert field().live.shape is shape  # the surface is not prepared anew


def test_without_live_graph_none_is_built(tube):
    bpy.context.scene.meshknit.live_graph = False
    settle()
    assert session().is_guidance_fresh() and session().value("graph") is None
    bpy.context.scene.meshknit.live_graph = True
    settle()
    assert session().is_fresh("graph")


def test_gauge_moves_the_lines(tube):
    settle()
    bpy.context.scene.meshknit.stitch_height = 3.0
    settle()
    assert field().rows.max() == pytest.approx(60.0 / 6.0, rel=0.01)
    assert session().is_fresh("graph")


def test_a_step_that_a_person_starts_comes_first(tube):
    while live.progress() is None or live.progress()[0] != live.GRAPH:
        live.time.sleep(live.tick())
    assert KNIT.solve_time() == {"FINISHED"}
    assert session().value("graph") is None  # it was not waited for
    settle()
    assert session().is_fresh("graph")


def test_changes_while_the_graph_is_built_start_it_again():
    KNIT.add_sock()
    for _ in range(2000):
        wait = live.tick()
        if live.progress() is not None and live.progress()[0] == live.GRAPH:
            break
        live.time.sleep(wait)
    entries()[0].time = -0.7
    live.tick()
    settle()
    assert session().is_fresh("graph")
    assert session().value("graph").nodes[:, 3].min() >= -0.7


def test_a_deleted_or_renamed_object_takes_its_work_along(tube):
    live.tick()
    bpy.data.objects.remove(bpy.context.object)
    settle()
    KNIT.add_straight_tube(radius=20.0, length=60.0)
    live.tick()
    live.tick()
    bpy.context.object.name = "Renamed"
    settle()
    assert field() is not None and session().is_fresh("graph")


def test_undo_while_work_is_going_on(tube):
    bpy.ops.ed.undo_push(message="tube")
    entries()[0].time = -0.5
    bpy.ops.ed.undo_push(message="time")
    live.tick()
    live.tick()
    bpy.ops.ed.undo()
    settle()
    assert field().times.min() == -1.0 and session().is_fresh("graph")


def test_a_loaded_file_begins_anew(tube, tmp_path):
    path = str(tmp_path / "tube.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    live.tick()
    live.tick()
    bpy.ops.wm.open_mainfile(filepath=path)
    assert live.progress() is None
    settle()
    assert field().times.max() == 1.0 and session().is_fresh("graph")


def test_edit_mode_waits_but_times_follow(tube):
    settle()
    bpy.ops.object.mode_set(mode="EDIT")
    entries()[0].time = -0.5
    live.tick()
    assert field().times.min() == -0.5
    assert live.progress() is None  # nothing reads a mesh that is being edited
    bpy.ops.object.mode_set(mode="OBJECT")
    settle()
    assert session().is_fresh("graph")


def test_what_modifiers_make_is_what_is_solved(tube):
    modifier = tube.modifiers.new("Subdivide", "SUBSURF")
    modifier.levels = 1
    settle()
    assert len(field().times) > 3 * len(tube.data.vertices)
    assert (field().times.min(), field().times.max()) == (-1.0, 1.0)


def test_a_scaled_child_of_a_moved_parent_is_shown_where_it_is(tube):
    settle()
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.collection.objects.link(parent)
    tube.parent = parent
    parent.location, tube.scale = (0.5, 0.0, 0.0), (1.0, 1.0, 2.0)
    bpy.context.view_layer.update()
    settle()
    # Twice as high, so twice the rows; and where the parent is.
    assert field().rows.max() == pytest.approx(2 * 60.0 / 3.46, rel=0.01)
    assert field().live.shape.places[:, 0].mean() == pytest.approx(0.5, abs=1e-3)
    parent.location.x = 0.7
    bpy.context.view_layer.update()
    at = tube.matrix_world @ field().matrix.inverted()
    assert at.translation.x == pytest.approx(0.2, abs=1e-5)  # it is drawn with its object at once


def test_polygons_of_any_kind():
    vertices, polygons = meshes.tube()
    polygons = [p for p in polygons if p[0] >= 24] + [list(range(24, 48))[::-1]]
    ob = add_mesh(vertices, polygons)  # a cup with an n-gon for its bottom
    KNIT.add_boundary_constraint(time=1.0)
    KNIT.add_opening(location=(0.0, 0.0, 0.01), radius=8.0, time=-1.0)
    settle()
    assert (field().times.min(), field().times.max()) == (-1.0, 1.0)
    assert len(field().times) > len(ob.data.vertices)  # the rim of the opening is cut


def test_a_field_of_the_users_own():
    ob = add_mesh(*meshes.tube())
    values = [vertex.co.z / 0.03 - 1.0 for vertex in ob.data.vertices]
    ob.data.attributes.new("knit_time", "FLOAT", "POINT").data.foreach_set("value", values)
    ob.data.meshknit.time_source = "ATTRIBUTE"
    settle()
    np.testing.assert_allclose(field().times, values, atol=1e-6)
    assert session().is_fresh("graph")


def test_another_source_of_time_is_what_is_shown(tube):
    settings = bpy.context.object.data.meshknit
    settings.time_source, settings.time_axis = "HEIGHT", "-Z"
    settle()
    # The constraints say that the lower rim is first; by the height downwards it is last.
    lowest = np.argmin(field().live.shape.places[:, 2])
    assert field().times[lowest] == pytest.approx(1.0)
    settings.time_source = "CONSTRAINTS"
    settle()
    assert field().times[lowest] == pytest.approx(-1.0)


def test_meshes_that_nobody_means_to_knit_are_left_in_peace():
    add_mesh(*meshes.ball())
    assert live.tick() is None and field() is None and live.progress() is None


def test_a_removed_mark_leaves_no_old_field(tube):
    settle()
    KNIT.remove_constraint(index=0)
    KNIT.remove_constraint(index=0)
    settle()
    assert field() is None and not session().is_fresh("graph")


def test_what_time_changes_is_not_read_again(tube, monkeypatch):
    settle()
    reads = []
    monkeypatch.setattr(sessions, "read_as_it_is", lambda *_: reads.append(1))
    for time in np.linspace(-1.0, -0.5, 6):
        entries()[0].time = time
        live.tick()
        # Blender tells of it as of a changed mesh.
        bpy.context.view_layer.update()
    assert reads == [] and field().times.min() == pytest.approx(-0.5)


def test_a_chain_shows_its_field_while_it_is_drawn(tube):
    settle()
    ring = list(range(2 * 36, 2 * 36 + 12))
    live.draw_chain(tube, ring, 0.9)
    for _ in range(500):
        if live.tick() == live.WAIT:
            break
        live.time.sleep(live.POLL)
    assert (field().times[ring] == 0.9).all()
    # It is no mark yet, and what is built is not of it.
    assert len(entries()) == 2 and not session().is_fresh("graph")
    live.end_chain()
    settle()
    assert (field().times[ring] < 0.5).all() and session().is_fresh("graph")


def test_first_rows_are_there_before_the_graph_is(tube):
    library = native.load()
    model, settings = sessions.read_as_it_is(bpy.context, tube)
    first_rows, run = library.FirstRows(), library.RunContext()
    assert first_rows.take() is None, "nothing is knit yet; but now the rows are asked for"
    outcome = run_stages(library, model, settings, "graph", run, first_rows=first_rows)
    rows, graph = first_rows.take(), outcome.results["graph"].value
    assert 0 < len(rows.nodes) < len(graph.nodes)
    edges, _ = rows.row_edges
    assert edges.max() < len(rows.nodes)
    session = sessions.session_of(tube)
    session.show_first_rows((rows, model.scale))
    assert session.shown_graph() == (rows, model.scale, False)
    session.show_first_rows(None)
    assert session.shown_graph() is None


def test_an_object_of_instances_says_so():
    child = add_mesh(*meshes.tube(), name="Child")
    points = bpy.data.meshes.new("Around")
    points.from_pydata([(0.0, 0.0, 0.0), (0.1, 0.0, 0.0)], [], [])
    around = add_object(bpy.context, points)
    child.parent = around
    around.instance_type = "VERTS"
    bpy.context.view_layer.objects.active = around
    with pytest.raises(RuntimeError, match="instances"):
        KNIT.check_mesh()
