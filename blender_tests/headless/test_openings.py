"""Openings live on the mesh: added, removed, selected, undone, saved, knit; the mesh stays whole."""

import bpy
import numpy as np
import pytest

import meshes
from meshknit.scene.attributes import read_attribute
from meshknit.scene.openings import store_openings
from objects import add_mesh, heights, knit_time, session, times

KNIT = bpy.ops.meshknit


@pytest.fixture
def ball():
    """A closed ball of 50 mm radius."""
    return add_mesh(*meshes.ball())


def openings(ob):
    return [(o.name, round(o.time, 4)) for o in ob.data.meshknit.openings]


def numbers(ob):
    return read_attribute(ob.data, "knit_opening", "INT", "FACE")


def polar_faces(ob, pole):
    """The fan of faces round a pole: -1 below, 1 above."""
    return {p.index for p in ob.data.polygons if p.center.z * pole > 0.048}


def select_faces(ob, faces):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    for polygon in ob.data.polygons:
        polygon.select = polygon.index in faces
    bpy.ops.object.mode_set(mode="EDIT")


def test_a_ball_with_two_round_openings_is_knit(ball, tmp_path):
    count = len(ball.data.vertices), len(ball.data.polygons)
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    KNIT.add_opening(location=(0, 0, 0.05), radius=15.0)
    assert openings(ball) == [("Opening 1", -1.0), ("Opening 2", 1.0)]
    KNIT.write_knitout(output=str(tmp_path / "ball.k"))
    report = session().report
    assert report["ok"] and report["check"]["ok"] and (tmp_path / "ball.k").exists()
    assert [o["radius"] for o in report["openings"]] == [20.0, 15.0]
    assert (len(ball.data.vertices), len(ball.data.polygons)) == count
    # The field is on the user's own vertices; inside the openings there is none.
    field, height = knit_time(ball), heights(ball)
    assert (field[np.abs(height) > 0.0495] == 0.0).all()
    middle = np.abs(height) < 0.04
    assert np.corrcoef(field[middle], height[middle])[0, 1] > 0.98


def test_selected_faces_become_an_opening(ball, tmp_path):
    for pole in (-1, 1):
        select_faces(ball, polar_faces(ball, pole))
        KNIT.add_opening()
        assert ball.mode == "EDIT"
        bpy.ops.object.mode_set(mode="OBJECT")
    assert openings(ball) == [("Opening 1", -1.0), ("Opening 2", 1.0)]
    assert set(np.flatnonzero(numbers(ball) == 1)) == polar_faces(ball, -1)
    assert set(np.flatnonzero(numbers(ball) == 2)) == polar_faces(ball, 1)
    KNIT.write_knitout(output=str(tmp_path / "ball.k"))
    report = session().report
    assert report["check"]["ok"]
    assert set(report["openings"][1]["faces"]) == polar_faces(ball, 1)


def test_nothing_selected_is_refused(ball):
    select_faces(ball, ())
    with pytest.raises(RuntimeError, match="Select the faces"):
        KNIT.add_opening()
    assert openings(ball) == []


def test_the_attribute_alone_leaves_faces_out(ball):
    # As Geometry Nodes or a script would mark them; a constraint on their rim gives the time.
    KNIT.add_opening(location=(0, 0, 0.05), radius=15.0, time=1.0)
    faces = polar_faces(ball, -1)
    ball.data.attributes.new("knit_opening", "INT", "FACE")
    for face in faces:
        ball.data.attributes["knit_opening"].data[face].value = 9
    with pytest.raises(RuntimeError):
        KNIT.solve_time()
    ring = sorted({v for f in faces for v in ball.data.polygons[f].vertices if v != 0})
    points = str([list(ball.data.vertices[v].co) for v in ring])
    KNIT.add_time_constraint(time=-1.0, points=points, closed=True)
    assert KNIT.build_graph() == {"FINISHED"}


def test_the_cursor_places_an_opening_in_object_mode(ball):
    bpy.context.scene.cursor.location = (0.05, 0.0, 0.0)
    KNIT.add_opening()
    entry = ball.data.meshknit.openings[0]
    assert tuple(entry.location) == pytest.approx((0.05, 0, 0)) and entry.number == 0
    assert entry.radius == pytest.approx(0.015)


def test_removing_one_leaves_the_others_alone(ball):
    select_faces(ball, polar_faces(ball, -1))
    KNIT.add_opening()
    select_faces(ball, polar_faces(ball, 1))
    KNIT.add_opening()
    bpy.ops.object.mode_set(mode="OBJECT")
    KNIT.add_opening(location=(0.05, 0, 0), radius=10.0, time=0.25)
    KNIT.remove_opening(index=0)
    assert openings(ball) == [("Opening 2", 1.0), ("Opening 3", 0.25)]
    assert set(np.flatnonzero(numbers(ball))) == polar_faces(ball, 1)
    KNIT.remove_opening()  # the active one is the last that was added
    KNIT.remove_opening()
    assert openings(ball) == [] and not numbers(ball).any()


def test_openings_follow_the_object(ball):
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    KNIT.add_opening(location=(0, 0, 0.05), radius=20.0)
    ball.location, ball.rotation_euler, ball.scale = (1.0, 2.0, 3.0), (0.3, 0.4, 0.5), (2, 2, 2)
    bpy.context.view_layer.update()
    KNIT.solve_time()
    for opening in session().report["openings"]:
        assert opening["radius"] == pytest.approx(40.0)
    # Millimetres are those of the finished object, whatever its scale.
    KNIT.add_opening(location=(1.0, 2.0, 3.0), radius=30.0)
    assert ball.data.meshknit.openings[2].radius == pytest.approx(0.015)


def test_undo_and_redo(ball):
    bpy.ops.ed.undo_push(message="before")
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    assert openings(bpy.data.objects["Mesh"]) == []
    bpy.ops.ed.redo()
    assert openings(bpy.data.objects["Mesh"]) == [("Opening 1", -1.0)]


def test_saving_and_loading_keeps_openings(ball, tmp_path):
    select_faces(ball, polar_faces(ball, -1))
    KNIT.add_opening(time=-1.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    KNIT.add_opening(location=(0, 0, 0.05), radius=15.0, time=0.5)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "ball.blend"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "ball.blend"))
    ob = bpy.context.object
    assert openings(ob) == [("Opening 1", -1.0), ("Opening 2", 0.5)]
    assert numbers(ob).sum() == 24
    assert KNIT.build_graph() == {"FINISHED"}


def test_an_opening_without_a_time_is_named(ball):
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    KNIT.add_opening(location=(0, 0, 0.05), radius=15.0)
    ball.data.meshknit.openings[1].name = "Neck"
    ball.data.meshknit.openings[1].has_time = False
    with pytest.raises(RuntimeError):
        KNIT.solve_time()
    problems = session().problems
    (index,) = [i for i, p in enumerate(problems) if p["code"] == "boundary-without-time"]
    assert "Neck" in problems[index]["message"]
    KNIT.select_problem(index=index)
    bpy.ops.object.mode_set(mode="OBJECT")
    chosen = [v.co.z for v in ball.data.vertices if v.select]
    assert chosen and min(chosen) > 0.03


def test_a_problem_of_an_opening_shows_its_place(ball):
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    KNIT.add_opening(location=(0.05, 0, 0), radius=1.0)
    with pytest.raises(RuntimeError, match="at least"):
        KNIT.check_mesh()
    KNIT.select_problem(index=0)
    bpy.ops.object.mode_set(mode="OBJECT")
    (face,) = [p for p in ball.data.polygons if p.select]
    assert face.center.x > 0.045


def test_select_shows_an_opening(ball):
    select_faces(ball, polar_faces(ball, 1))
    KNIT.add_opening()
    bpy.ops.object.mode_set(mode="OBJECT")
    KNIT.add_opening(location=(0, 0, -0.05), radius=20.0)
    KNIT.select_opening(index=0)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert {p.index for p in ball.data.polygons if p.select} == polar_faces(ball, 1)
    KNIT.select_opening(index=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [v.index for v in ball.data.vertices if v.select] == [0]


def test_openings_of_an_example_are_stored_with_their_times(ball):
    store_openings(ball.data, [((0, 0, -0.05), 0.02, -1.0), ((0, 0, 0.05), 0.02, None)])
    assert [o.has_time for o in ball.data.meshknit.openings] == [True, False]
    ball.data.meshknit.openings[1].has_time = True
    ball.data.meshknit.openings[1].time = 1.0
    assert KNIT.build_graph() == {"FINISHED"}
    assert times(ball) == []  # no constraint is needed


def test_faces_left_out_stay_so_below_a_modifier(ball):
    for pole in (-1, 1):
        select_faces(ball, polar_faces(ball, pole))
        KNIT.add_opening()
        bpy.ops.object.mode_set(mode="OBJECT")
    ball.modifiers.new("Subdivision", "SUBSURF").levels = 1
    assert KNIT.build_graph() == {"FINISHED"}
    assert len(session().report["openings"]) == 2
