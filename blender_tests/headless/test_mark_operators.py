"""What the Knit Time tool does by mouse and key, as scripts do it."""

import bpy
import numpy as np
import pytest

import meshes
from meshknit import native
from meshknit.core.marks import parse_marks, resolve_marks
from meshknit.scene.attributes import read_attribute
from meshknit.tool import icon
from objects import add_mesh, heights, marked_edges, select_only, session, times

KNIT = bpy.ops.meshknit
BOTTOM = {tuple(sorted((j, (j + 1) % 24))) for j in range(24)}
MIDDLE = {(a + 72, b + 72) for a, b in BOTTOM}
UPRIGHT = {(24 * i, 24 * i + 24) for i in range(6)}


@pytest.fixture
def tube():
    """24 quads round, 6 along, 60 mm high; vertex j of ring i is 24 i + j."""
    return add_mesh(*meshes.tube())


def selected(ob):
    settings = ob.data.meshknit
    if settings.selected_kind == "OPENING":
        return "OPENING", settings.active_opening
    return "CONSTRAINT", settings.active


def openings(ob):
    return [(round(o.time, 4), round(o.radius, 5)) for o in ob.data.meshknit.openings]


def test_a_chain_is_drawn_through_vertices(tube):
    KNIT.draw_constraint(vertices="[0, 72, 144]", time=0.25)
    assert times(tube) == [0.25] and marked_edges(tube, 0) == UPRIGHT
    KNIT.draw_constraint(vertices="[72, 80, 88]", closed=True, time=0.5)
    assert times(tube) == [0.25, 0.5] and marked_edges(tube, 1) == MIDDLE


def test_a_chain_is_drawn_anew(tube):
    KNIT.draw_constraint(vertices="[0, 144]", time=0.25)
    KNIT.draw_constraint(vertices="[24, 96]", time=0.5, index=0)
    assert times(tube) == [0.5]
    assert marked_edges(tube, 0) == {(24, 48), (48, 72), (72, 96)}


def test_the_shortest_way_is_that_of_the_world():
    # From 0 to 2 over 1, which lies 4 mm aside, or over 3, which lies 3 mm below.
    corners = [(0, 0, 0), (5, 4, 0), (10, 0, 0), (5, 0, -3)]
    ob = add_mesh(corners, [[0, 1, 2, 3]])
    KNIT.draw_constraint(vertices="[0, 2]", time=0.0)
    assert marked_edges(ob, 0) == {(0, 3), (2, 3)}
    ob.scale = (1.0, 1.0, 4.0)  # now it is 12 mm below
    bpy.context.view_layer.update()
    KNIT.draw_constraint(vertices="[0, 2]", time=0.0)
    assert marked_edges(ob, 1) == {(0, 1), (1, 2)}


@pytest.mark.parametrize(
    "vertices, reason",
    [
        ("[0, 9000]", "no vertex 9000"),
        ("[0]", "at least two"),
        ("[0, 1.5]", "whole numbers"),
        ("[-1, 3]", "whole numbers"),
        ("here", "written"),
        ("[5, 5]", "one vertex"),
    ],
)
def test_chains_that_cannot_be_are_refused(tube, vertices, reason):
    with pytest.raises(RuntimeError, match=reason):
        KNIT.draw_constraint(vertices=vertices, time=0.0)
    with pytest.raises(RuntimeError, match="no constraint 3"):
        KNIT.draw_constraint(vertices="[0, 1]", index=3)
    assert times(tube) == [] and "knit_constraint" not in tube.data.attributes


def test_no_chain_leads_from_piece_to_piece():
    vertices, polygons = meshes.tube()
    far = np.array(vertices) + (100.0, 0.0, 0.0)
    both = [*polygons, *([v + len(vertices) for v in p] for p in polygons)]
    ob = add_mesh(np.vstack([vertices, far]), both)
    with pytest.raises(RuntimeError, match="No edges lead"):
        KNIT.draw_constraint(vertices=f"[0, {len(vertices)}]", time=0.0)
    assert times(ob) == []


def test_a_chain_that_loses_its_last_edge_to_another_is_gone(tube):
    KNIT.draw_constraint(vertices="[24, 48]", time=-0.5)
    KNIT.draw_constraint(vertices="[1, 25]", time=0.1)
    KNIT.draw_constraint(vertices="[0, 144]", time=0.5)
    assert times(tube) == [0.1, 0.5]
    assert marked_edges(tube, 0) == {(1, 25)} and marked_edges(tube, 1) == UPRIGHT
    assert selected(tube) == ("CONSTRAINT", 1)


def test_take_boundary_takes_the_whole_loop(tube):
    KNIT.take_boundary(vertex=5, time=-1.0)
    assert times(tube) == [-1.0] and marked_edges(tube, 0) == BOTTOM
    with pytest.raises(RuntimeError, match="no boundary"):
        KNIT.take_boundary(vertex=72)


def test_drag_opening_makes_a_round_one(tube):
    tube.location = (1.0, 0.0, 0.0)
    bpy.context.view_layer.update()
    KNIT.drag_opening(location=(1.03, 0.0, 0.03), radius=8.0, time=0.0)
    entry = tube.data.meshknit.openings[0]
    np.testing.assert_allclose(entry.location, (0.03, 0.0, 0.03), atol=1e-6)
    assert openings(tube) == [(0.0, 0.008)] and selected(tube) == ("OPENING", 0)


def test_keys_act_on_the_mark_that_was_picked_last(tube):
    with pytest.raises(RuntimeError, match="no constraint or opening yet"):
        KNIT.change_time(delta=0.1)
    KNIT.take_boundary(vertex=5, time=-1.0)
    KNIT.draw_constraint(vertices="[72, 75]", time=0.2)
    KNIT.drag_opening(location=(0.03, 0.0, 0.03), radius=8.0, time=0.0)
    KNIT.change_time(delta=0.1)
    assert openings(tube) == [(0.1, 0.008)] and times(tube) == [-1.0, 0.2]
    KNIT.pick_mark(kind="CONSTRAINT", index=0)
    KNIT.change_time(delta=0.01)
    assert times(tube) == [-0.99, 0.2]
    KNIT.set_time(time=0.75)
    KNIT.change_time(delta=0.5)  # no later than the last
    assert times(tube) == [1.0, 0.2]
    KNIT.remove_mark()
    assert times(tube) == [0.2] and len(openings(tube)) == 1
    KNIT.remove_mark()
    KNIT.remove_mark()  # with no constraint left it is the opening's turn
    assert times(tube) == [] and openings(tube) == []
    for kind in ("CONSTRAINT", "OPENING"):
        with pytest.raises(RuntimeError, match="There is no"):
            KNIT.pick_mark(kind=kind, index=0)


def test_ten_steps_of_a_tenth_are_one(tube):
    KNIT.draw_constraint(vertices="[72, 75]", time=0.0)
    for _ in range(7):
        KNIT.change_time(delta=0.1)
    assert tube.data.meshknit.constraints[0].time == pytest.approx(0.7, abs=1e-7)


def test_a_row_of_the_panels_list_is_what_keys_act_on(tube):
    KNIT.take_boundary(vertex=5, time=-1.0)
    KNIT.drag_opening(location=(0.03, 0.0, 0.03), radius=8.0, time=0.0)
    tube.data.meshknit.active = 0
    KNIT.remove_mark()
    assert times(tube) == [] and len(openings(tube)) == 1


def test_every_seam_becomes_a_constraint(tube):
    for edge in tube.data.edges:
        pair = tuple(sorted(edge.vertices))
        edge.use_seam = pair in MIDDLE or pair in {(0, 24), (24, 48)}
    KNIT.add_from_seams(time=0.3)
    assert times(tube) == [0.3, 0.3]
    assert {frozenset(marked_edges(tube, i)) for i in (0, 1)} == {
        frozenset(MIDDLE), frozenset({(0, 24), (24, 48)})
    }  # fmt: skip
    assert KNIT.add_from_seams(time=0.5) == {"CANCELLED"}  # they have times already


def test_seams_that_branch_are_refused(tube):
    with pytest.raises(RuntimeError, match="no UV seams"):
        KNIT.add_from_seams()
    for edge in tube.data.edges:
        edge.use_seam = tuple(sorted(edge.vertices)) in MIDDLE | {(72, 96)}
    with pytest.raises(RuntimeError, match="branch"):
        KNIT.add_from_seams()
    assert times(tube) == []


def test_a_time_is_assigned_to_selected_edges_and_then_changed(tube):
    select_only(tube, edges=MIDDLE)
    KNIT.assign_time(time=0.25)
    KNIT.assign_time(time=0.5)
    assert tube.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert times(tube) == [0.5] and marked_edges(tube, 0) == MIDDLE


def test_an_own_field_gets_the_time_at_selected_vertices(tube):
    tube.data.meshknit.time_source = "ATTRIBUTE"
    with pytest.raises(RuntimeError, match="Select the vertices"):
        select_only(tube)
        KNIT.assign_time(time=0.5)
    select_only(tube, vertices=range(24))
    KNIT.assign_time(time=-0.5)
    select_only(tube, vertices=range(144, 168))
    KNIT.assign_time(time=0.5)
    bpy.ops.object.mode_set(mode="OBJECT")
    field = read_attribute(tube.data, "knit_time", "FLOAT", "POINT")
    assert (field[:24] == -0.5).all() and (field[144:] == 0.5).all() and not field[24:144].any()
    assert times(tube) == []


def test_undo_in_edit_mode_takes_back_the_lists_too(tube):
    bpy.ops.ed.undo_push(message="tube")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.ed.undo_push(message="edit")
    states = [((), ())]
    for act in (
        lambda: KNIT.take_boundary(vertex=0, time=-1.0),
        lambda: KNIT.draw_constraint(vertices="[72, 75]", time=0.2),
        lambda: KNIT.change_time(delta=0.1),
        lambda: setattr(bpy.context.object.data.meshknit.constraints[0], "time", -0.5),
        lambda: KNIT.drag_opening(location=(0.03, 0, 0.03), radius=8.0, time=0.0),
        lambda: KNIT.remove_constraint(index=0),
    ):
        act()
        bpy.ops.ed.undo_push(message="act")
        ob = bpy.context.object
        states.append((tuple(times(ob)), tuple(openings(ob))))
    assert states[-1] == ((0.3,), ((0.0, 0.008),)) and len(set(states)) == 7
    for expected in reversed(states[:-1]):
        bpy.ops.ed.undo()
        ob = bpy.context.object
        assert (tuple(times(ob)), tuple(openings(ob))) == expected and ob.mode == "EDIT"
    for expected in states[1:]:
        bpy.ops.ed.redo()
        ob = bpy.context.object
        assert (tuple(times(ob)), tuple(openings(ob))) == expected and ob.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    ob = bpy.context.object
    assert marked_edges(ob, 0) == {(72, 73), (73, 74), (74, 75)}


def test_scripts_and_marks_files_give_the_same_chain():
    vertices, polygons = meshes.tube()
    # Shaken, so that no two ways are equally long.
    vertices = vertices + 0.8 * np.sin(np.arange(vertices.size) * 7.0).reshape(vertices.shape)
    triangles = [t for p in polygons for t in ([p[0], p[1], p[2]], [p[0], p[2], p[3]])]
    ob = add_mesh(vertices, triangles)
    points = [vertices[row].tolist() for row in (0, 78, 156)]
    KNIT.add_time_constraint(time=0.4, points=str([[x / 1000 for x in p] for p in points]))
    data = {"format": "meshknit-marks-1", "times": [{"time": 0.4, "points": points}]}
    surface = native.load().Surface(np.array(vertices), np.array(triangles))
    (mark,) = resolve_marks(parse_marks(data), surface, 1.0)
    assert {v for edge in marked_edges(ob, 0) for v in edge} == set(mark.vertices)
    assert times(ob) == [mark.time] == [0.4]


def test_a_drawn_chain_tilts_the_field(tube):
    KNIT.take_boundary(vertex=0, time=-1.0)
    KNIT.take_boundary(vertex=144, time=1.0)
    KNIT.solve_time()
    before = read_attribute(tube.data, "knit_time", "FLOAT", "POINT")
    KNIT.draw_constraint(vertices="[72, 76]", time=0.3)
    KNIT.solve_time()
    after = read_attribute(tube.data, "knit_time", "FLOAT", "POINT")
    middle = heights(tube) == np.float32(0.03)
    assert np.abs(before[middle]).max() < 1e-5
    np.testing.assert_allclose(after[72:77], 0.3, atol=1e-6)
    assert after[middle].max() < 0.3 + 1e-6 and after[middle].min() < 0.15  # the far side less
    assert session().report["ok"]


def test_a_linked_mesh_says_why_it_cannot_be_marked(tube, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "tube.blend"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "tube.blend"), link=True) as (_, wanted):
        wanted.objects = ["Mesh"]
    bpy.context.collection.objects.link(wanted.objects[0])
    bpy.context.view_layer.objects.active = wanted.objects[0]
    with pytest.raises(RuntimeError, match="linked"):
        KNIT.draw_constraint(vertices="[0, 1]", time=0.0)


def test_the_icon_is_the_one_that_its_script_draws():
    with open(f"{icon.FILE}.dat", "rb") as file:
        assert file.read() == icon.icon_bytes()
    assert len(icon.icon_bytes()) == 8 + 18 * len(icon.triangles())


def test_the_tool_is_in_the_toolbar_of_both_modes(tube):
    from bl_ui.space_toolsystem_common import ToolSelectPanelHelper

    tools = ToolSelectPanelHelper._tool_class_from_space_type("VIEW_3D")._tools
    for mode in ("OBJECT", "EDIT_MESH"):
        flat = ToolSelectPanelHelper._tools_flatten(tools[mode])
        assert "meshknit.knit_time" in [item.idname for item in flat if item is not None]
