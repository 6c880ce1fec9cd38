"""Check, Solve time, Build graph, Schedule, Write: from the active object to its results."""

import json
from dataclasses import replace

import bpy
import numpy as np
import pytest

import meshes
from meshknit.core.errors import UsageError
from meshknit.core.workflow import stage_keys
from meshknit.operators import stage_base
from meshknit.scene import sessions
from meshknit.scene.read_overlay import read_time_surface
from objects import add_mesh, heights, knit_time, session, select_only

KNIT = bpy.ops.meshknit
SHAPES = ("straight_tube", "cone", "bent_tube", "sock")


@pytest.mark.parametrize("name", SHAPES)
def test_an_added_shape_is_ready_to_knit(name, tmp_path):
    assert getattr(KNIT, f"add_{name}")() == {"FINISHED"}
    path = tmp_path / f"{name}.k"
    report_path = tmp_path / "report.json"
    assert KNIT.write_knitout(output=str(path), report_file=str(report_path)) == {"FINISHED"}
    assert path.read_text().startswith(";!knitout-2")
    report = json.loads(report_path.read_text())
    assert report["ok"] and report["check"]["ok"]
    bends = name in ("bent_tube", "sock")
    assert (report["graph"]["short_rows"] > 0) == bends


def test_shapes_have_their_millimetres_whatever_the_scene_unit():
    bpy.context.scene.unit_settings.scale_length = 0.01
    KNIT.add_straight_tube(radius=20.0, length=60.0)
    assert max(bpy.context.object.dimensions) == pytest.approx(6.0)
    KNIT.build_graph()
    # 60 mm in rows of two courses of 1.73 mm.
    assert session().report["graph"]["rows"] == pytest.approx(60.0 / 3.46, abs=2)


def test_a_bent_tube_bends_as_far_as_asked():
    KNIT.add_bent_tube(angle=np.radians(60.0))
    KNIT.build_graph()
    fewer = session().report["graph"]["short_rows"]
    KNIT.add_bent_tube(angle=np.radians(120.0))
    KNIT.build_graph()
    assert 0 < fewer < session().report["graph"]["short_rows"]


def test_the_time_field_rises_with_the_height_of_a_tube(tube):
    KNIT.solve_time()
    np.testing.assert_allclose(knit_time(tube), heights(tube) / 0.03 - 1.0, atol=0.02)
    colors = tube.data.color_attributes["knit_time_color"]
    early, late = np.argmin(heights(tube)), np.argmax(heights(tube))
    assert colors.data[early].color[2] > colors.data[early].color[0]
    assert colors.data[late].color[0] > colors.data[late].color[2]


def test_a_stage_runs_the_stages_before_it_once(tube):
    KNIT.schedule()
    first = session().value("graph")
    KNIT.schedule()
    assert session().value("graph") is first
    assert session().stale_stages() == []


def test_results_are_stale_after_the_mesh_or_the_gauge_changes(tube):
    KNIT.schedule()
    graph = session().value("graph")
    bpy.context.scene.meshknit.stitch_height = 2.0
    sessions.look_again(bpy.context, tube)
    assert session().stale_stages() == ["graph", "trace", "schedule"]
    bpy.context.scene.meshknit.stitch_height = 1.73
    sessions.look_again(bpy.context, tube)
    assert session().stale_stages() == []
    bpy.context.scene.meshknit.relax = False
    sessions.look_again(bpy.context, tube)
    assert session().stale_stages() == ["graph", "trace", "schedule"]
    bpy.context.scene.meshknit.relax = True
    sessions.look_again(bpy.context, tube)
    tube.data.vertices[200].co.x *= 1.05
    sessions.look_again(bpy.context, tube)
    assert not session().is_fresh("check") and not session().is_fresh("graph")
    KNIT.build_graph()
    assert session().value("graph") is not graph and session().is_fresh("graph")
    assert session().stale_stages() == ["trace", "schedule"]


def test_a_changed_time_makes_the_field_stale(tube):
    KNIT.solve_time()
    tube.data.meshknit.constraints[1].time = 0.5
    sessions.look_again(bpy.context, tube)
    assert session().stale_stages() == ["time"]
    KNIT.solve_time()
    assert knit_time(tube).max() == pytest.approx(0.5)


def test_scale_rotation_and_place_of_the_object_count(tube):
    KNIT.build_graph()
    small = session().report["graph"]["rows"]
    tube.scale, tube.rotation_euler, tube.location = (2, 2, 2), (1.0, 0.5, 0.2), (3, 2, 1)
    KNIT.build_graph()
    assert session().report["graph"]["rows"] == pytest.approx(2 * small, abs=2)
    assert session().value("graph").nodes[:, 0].min() > 2000.0  # mm, in world space


def test_a_mirrored_object_keeps_its_outside_out(tube):
    KNIT.check_mesh()
    area = session().report["mesh"]["area"]
    tube.scale.x = -1.0
    KNIT.check_mesh()
    assert session().report["mesh"]["area"] == pytest.approx(area)
    model, _ = sessions.read_inputs(bpy.context, tube)
    corners = model.vertices[model.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outward = corners.mean(axis=1) * (1, 1, 0)
    assert (np.einsum("ij,ij->i", normals, outward) > 0).all()


def test_the_longest_side_can_be_chosen(tube):
    tube.data.meshknit.size_mode = "SIZE"
    tube.data.meshknit.size = 180.0
    KNIT.build_graph()
    assert session().report["mesh"]["scale"] == pytest.approx(3000.0)
    tube.data.meshknit.size_mode = "SCALE"
    tube.data.meshknit.scale = 2000.0
    KNIT.check_mesh()
    assert session().report["mesh"]["scale"] == pytest.approx(2000.0)


def test_modifiers_count_and_constraints_go_through_them(tube):
    before = len(tube.data.vertices)
    tube.modifiers.new("Subdivision", "SUBSURF").levels = 1
    assert KNIT.build_graph() == {"FINISHED"}
    assert session().report["mesh"]["vertices"] > 3 * before
    np.testing.assert_allclose(knit_time(tube), heights(tube) / 0.03 - 1.0, atol=0.1)


def test_steps_work_in_edit_mode_and_stay_there(tube):
    bpy.ops.object.mode_set(mode="EDIT")
    assert KNIT.build_graph() == {"FINISHED"}
    assert tube.mode == "EDIT"


def test_a_field_of_the_users_own_is_used_and_not_overwritten(tube):
    own = (heights(tube) / 0.03 - 1.0).astype(np.float32)
    tube.data.attributes.new("knit_time", "FLOAT", "POINT")
    tube.data.attributes["knit_time"].data.foreach_set("value", own)
    tube.data.meshknit.time_source = "ATTRIBUTE"
    KNIT.build_graph()
    assert session().report["time_field"]["source"] == "attribute"
    np.testing.assert_array_equal(knit_time(tube), own)


def test_a_fault_is_listed_and_shown():
    vertices, polygons = meshes.tube()
    vertices = np.vstack([vertices, [[60.0, 0.0, 15.0]]])
    fin = [25, 49, len(vertices) - 1]  # a third face on an edge
    ob = add_mesh(vertices, polygons + [fin])
    with pytest.raises(RuntimeError):
        KNIT.check_mesh()
    (at,) = [i for i, p in enumerate(session().problems) if p["elements"].get("edges")][:1]
    KNIT.select_problem(index=at)
    assert ob.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert {v.index for v in ob.data.vertices if v.select} >= {25, 49}
    assert sum(v.select for v in ob.data.vertices) < 10


def test_a_boundary_without_a_time_is_shown_whole():
    ob = add_mesh(*meshes.tube())
    KNIT.add_boundary_constraint()
    with pytest.raises(RuntimeError):
        KNIT.solve_time()
    codes = [p["code"] for p in session().problems]
    KNIT.select_problem(index=codes.index("boundary-without-time"))
    bpy.ops.object.mode_set(mode="OBJECT")
    assert {v.index for v in ob.data.vertices if v.select} == set(range(144, 168))


def test_write_says_where_it_cannot_write(tube, tmp_path):
    with pytest.raises(RuntimeError, match="cannot write"):
        KNIT.write_knitout(output=str(tmp_path / "no" / "folder" / "x.k"))


def test_what_cannot_be_written_is_said_before_the_work(tube, tmp_path):
    for wrong in (
        {"output": str(tmp_path / "no" / "x.k")},
        {"output": str(tmp_path / "x.k"), "report_file": str(tmp_path / "no" / "r.json")},
        {"output": str(tmp_path / "x.k"), "graph": str(tmp_path)},
    ):
        with pytest.raises(RuntimeError, match="cannot write") as caught:
            KNIT.write_knitout(**wrong)
        assert "Traceback" not in str(caught.value)
    assert session().results == {}
    with pytest.raises(RuntimeError, match="cannot write") as caught:
        KNIT.write_knitout(output=str(tmp_path / ("x" * 300)))  # what only the system knows
    assert "Traceback" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_write_finds_a_place_for_its_file(tube, tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    tube.name = "My sock"
    KNIT.write_knitout()
    assert session().written == str(tmp_path / "My_sock.k")
    folder = tmp_path / "Documents"
    folder.mkdir()
    KNIT.write_knitout()
    assert session().written == str(folder / "My_sock.k")
    KNIT.write_knitout(output=str(tmp_path / "my.sock"))
    assert session().written == str(tmp_path / "my.sock.k")
    bpy.context.scene.meshknit.output = str(tmp_path)
    (tmp_path / "My_sock.k").unlink()
    KNIT.write_knitout()
    assert (tmp_path / "My_sock.k").read_text().startswith(";!knitout-2")


def test_write_warns_of_values_that_changed_while_it_ran(tube, tmp_path, monkeypatch, capfd):
    run = stage_base.run_stages

    def run_and_change(*arguments):
        outcome = run(*arguments)
        bpy.context.scene.meshknit.stitch_height = 2.0
        return outcome

    monkeypatch.setattr(stage_base, "run_stages", run_and_change)
    KNIT.write_knitout(output=str(tmp_path / "x.k"))
    assert "before your change" in capfd.readouterr().out


def test_a_graph_keeps_the_scale_that_it_was_built_at(tube):
    KNIT.build_graph()
    tube.data.meshknit.size_mode = "SIZE"
    tube.data.meshknit.size = 180.0
    KNIT.solve_time()
    assert session().results["graph"].scale == pytest.approx(1000.0)
    assert session().results["time"].scale == pytest.approx(3000.0)


def test_the_users_polygons_and_the_scale_are_part_of_every_key(tube):
    model, settings = sessions.read_inputs(bpy.context, tube)
    before = stage_keys(model, settings)
    for other in (replace(model, face_source=model.face_source + 1), replace(model, scale=5.0)):
        after = stage_keys(other, settings)
        assert all(before[stage] != after[stage] for stage in before)


def test_time_is_shown_as_modifiers_leave_the_mesh(tube):
    KNIT.solve_time()
    tube.modifiers.new("Subdivision", "SUBSURF").levels = 1
    points, colors, _ = read_time_surface(tube, bpy.context.evaluated_depsgraph_get())
    assert len(points) == len(colors) > 3 * len(tube.data.vertices)


def test_a_changed_unit_of_the_scene_is_noticed(tube):
    bpy.context.view_layer.update()
    before = sessions.mesh_revision(tube)
    bpy.context.view_layer.update()
    assert sessions.mesh_revision(tube) == before
    bpy.context.scene.unit_settings.scale_length = 0.5
    bpy.context.view_layer.update()
    assert sessions.mesh_revision(tube) > before


def test_a_hidden_object_is_named_not_shown(tube):
    KNIT.remove_constraint(index=1)
    with pytest.raises(RuntimeError):
        KNIT.solve_time()
    tube.hide_set(True)
    for show in (KNIT.select_problem, KNIT.select_constraint):
        with pytest.raises(RuntimeError, match="is hidden: show it first"):
            show(index=0)
    tube.hide_set(False)
    bpy.ops.object.mode_set(mode="EDIT")
    tube.hide_viewport = True
    assert tube.mode == "OBJECT" or not KNIT.check_mesh.poll()


def test_an_object_that_blender_leaves_out_is_not_knit_as_it_is_not(tube):
    tube.scale = (2.0, 2.0, 2.0)
    tube.hide_set(True)
    KNIT.check_mesh()
    # 2 pi r h of the tube, twice as large each way: one that is only out of sight is all there.
    assert session().report["mesh"]["area"] == pytest.approx(4 * 2 * np.pi * 20 * 60, rel=0.01)
    tube.hide_viewport = True
    with pytest.raises(RuntimeError, match="disabled in the viewport"):
        KNIT.check_mesh()


def test_an_object_that_is_edited_beside_the_active_one_is_left_alone(tube):
    bpy.ops.object.mode_set(mode="EDIT")
    other = add_mesh(*meshes.tube(), name="Other")
    assert (tube.mode, other.mode) == ("EDIT", "OBJECT")
    with pytest.raises(UsageError, match="Straight Tube is being edited"):
        sessions.read_inputs(bpy.context, tube)
    assert (tube.mode, other.mode) == ("EDIT", "OBJECT")


def test_results_of_a_linked_object_are_not_those_of_its_namesake(tube, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "tube.blend"), copy=True)
    with bpy.data.libraries.load(str(tmp_path / "tube.blend"), link=True) as (_, wanted):
        wanted.objects = [tube.name]
    (linked,) = wanted.objects
    bpy.context.collection.objects.link(linked)
    KNIT.check_mesh()
    assert linked.name == tube.name
    assert sessions.known_session(tube) and sessions.known_session(linked) is None


def test_without_a_mesh_steps_cannot_be_started():
    assert not KNIT.check_mesh.poll()
    bpy.ops.object.empty_add()
    assert not KNIT.build_graph.poll()
    assert not KNIT.cancel.poll()


def test_invoking_in_background_runs_to_the_end(tube):
    assert KNIT.build_graph("INVOKE_DEFAULT") == {"FINISHED"}
    assert session().is_fresh("graph")
