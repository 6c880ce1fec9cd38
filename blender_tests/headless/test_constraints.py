"""Time constraints live on the mesh: added, removed, selected, undone, saved."""

import bpy
import pytest

import meshes
from objects import add_mesh, marked_edges, select_only, times

KNIT = bpy.ops.meshknit
BOTTOM = {tuple(sorted((j, (j + 1) % 24))) for j in range(24)}
MIDDLE = {(a + 72, b + 72) for a, b in BOTTOM}


@pytest.fixture
def plain_tube():
    return add_mesh(*meshes.tube())


def test_two_boundaries_get_start_and_end(plain_tube):
    KNIT.add_boundary_constraint()
    KNIT.add_boundary_constraint()
    assert times(plain_tube) == [-1.0, 1.0]
    assert marked_edges(plain_tube, 0) == BOTTOM
    assert KNIT.add_boundary_constraint() == {"CANCELLED"}  # no third boundary


def test_in_edit_mode_the_selected_boundary_is_taken(plain_tube):
    select_only(plain_tube, vertices=[6 * 24 + 3])
    KNIT.add_boundary_constraint(time=0.5)
    assert plain_tube.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert times(plain_tube) == [0.5]
    assert marked_edges(plain_tube, 0) == {(a + 144, b + 144) for a, b in BOTTOM}


def test_a_selected_edge_loop_becomes_a_constraint(plain_tube):
    select_only(plain_tube, edges=MIDDLE)
    KNIT.add_time_constraint(time=0.25)
    assert plain_tube.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert times(plain_tube) == [0.25] and marked_edges(plain_tube, 0) == MIDDLE


def test_selected_edges_that_branch_or_fall_apart_are_refused(plain_tube):
    for edges in (MIDDLE | {(72, 96)}, BOTTOM | MIDDLE, set()):
        select_only(plain_tube, edges=edges)
        with pytest.raises(RuntimeError, match="Select"):
            KNIT.add_time_constraint(time=0.0)
    assert times(plain_tube) == []


def test_scripts_name_places_instead(plain_tube):
    plain_tube.location = (1.0, 0.0, 0.0)
    bpy.context.view_layer.update()
    KNIT.add_time_constraint(time=-1.0, boundary_near=(1.0, 0.0, -0.1))
    KNIT.add_time_constraint(time=0.0, points="[[1.03, 0, 0], [1.03, 0, 0.06]]")
    assert times(plain_tube) == [-1.0, 0.0]
    assert marked_edges(plain_tube, 0) == BOTTOM
    assert marked_edges(plain_tube, 1) == {(24 * i, 24 * i + 24) for i in range(6)}
    with pytest.raises(RuntimeError, match="three numbers"):
        KNIT.add_time_constraint(time=0.0, points="[[1.03, 0]]")


def test_removing_one_leaves_the_others_edges_alone(plain_tube):
    KNIT.add_boundary_constraint()
    select_only(plain_tube, edges=MIDDLE)
    KNIT.add_time_constraint(time=0.25)
    bpy.ops.object.mode_set(mode="OBJECT")
    KNIT.remove_constraint(index=0)
    assert times(plain_tube) == [0.25] and marked_edges(plain_tube, 0) == MIDDLE


def test_select_shows_the_edges(plain_tube):
    KNIT.add_boundary_constraint()
    KNIT.select_constraint(index=0)
    assert plain_tube.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    chosen = {v.index for v in plain_tube.data.vertices if v.select}
    assert chosen == set(range(24))


def test_subdividing_keeps_a_constraint_on_its_line(plain_tube):
    KNIT.add_boundary_constraint()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    edges = marked_edges(plain_tube, 0)
    assert len(edges) == 48
    assert all(plain_tube.data.vertices[v].co.z == 0.0 for edge in edges for v in edge)


def test_undo_and_redo(plain_tube):
    bpy.ops.ed.undo_push(message="before")
    KNIT.add_boundary_constraint()
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    ob = bpy.data.objects["Mesh"]
    assert times(ob) == [] and "knit_constraint" not in ob.data.attributes
    bpy.ops.ed.redo()
    ob = bpy.data.objects["Mesh"]
    assert times(ob) == [-1.0] and marked_edges(ob, 0) == BOTTOM


def test_saving_and_loading_keeps_everything(plain_tube, tmp_path):
    KNIT.add_boundary_constraint()
    KNIT.add_boundary_constraint()
    plain_tube.data.meshknit.size_mode = "SIZE"
    plain_tube.data.meshknit.size = 120.0
    bpy.context.scene.meshknit.stitch_width = 4.5
    KNIT.solve_time()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "tube.blend"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "tube.blend"))
    ob = bpy.context.object
    assert times(ob) == [-1.0, 1.0] and marked_edges(ob, 0) == BOTTOM
    assert ob.data.meshknit.size == 120.0
    assert bpy.context.scene.meshknit.stitch_width == 4.5
    assert {"knit_time", "knit_time_color"} <= set(ob.data.attributes.keys())
    assert KNIT.build_graph() == {"FINISHED"}
