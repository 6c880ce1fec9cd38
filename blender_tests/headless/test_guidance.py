"""What the sidebar says before a graph is built, and its remedies."""

import bpy
import numpy as np
import pytest

import meshes
from meshknit.scene.attributes import read_attribute, write_attribute
from objects import add_mesh, session, settle, times

KNIT = bpy.ops.meshknit


def findings():
    settle()
    return {p["code"]: (i, p) for i, p in enumerate(session().guidance.problems)}


def number(name):
    return session().guidance.numbers and dict(session().guidance.numbers)[name]


def test_a_tube_that_is_ready_has_nothing_in_its_way(tube):
    assert findings() == {}
    # 60 mm of rows of 3.46 mm; a radius of 20 mm in stitches of 3.66 mm: 34 round, half of them on
    # each bed, on every other needle, so as many needles and room for those beside it.
    assert number("Rows") == "about 17"
    round_it = 2.0 * np.pi * 20.0 / 3.66
    used = int(number("Needles").split()[0])
    assert round_it <= used <= 1.4 * round_it
    # 17.3 rows of 34 nodes, two stitches each.
    stitches = int(number("Stitches").split()[-1])
    assert stitches == pytest.approx(2 * 60.0 / 3.46 * round_it, rel=0.05)
    assert session().guidance.saddles == ()


def test_a_boundary_without_a_time_gets_it_by_a_click(tube):
    KNIT.remove_constraint(index=1)
    index, problem = findings()["boundary-without-time"]
    assert "GIVE_TIME" in problem["actions"]
    assert KNIT.give_time(index=index) == {"FINISHED"}
    assert sorted(times(tube)) == [-1.0, 1.0]
    assert "boundary-without-time" not in findings()


def test_a_rim_without_a_time_gets_it_by_a_click():
    ob = add_mesh(*meshes.ball())
    KNIT.add_opening(location=(0.0, 0.0, -0.05), radius=12.0, time=-1.0)
    KNIT.add_opening(location=(0.0, 0.0, 0.05), radius=12.0, time=1.0)
    ob.data.meshknit.openings[1].has_time = False
    index, _ = findings()["boundary-without-time"]
    KNIT.give_time(index=index)
    assert ob.data.meshknit.openings[1].has_time and ob.data.meshknit.openings[1].time == 1.0
    assert "boundary-without-time" not in findings()


def test_a_false_extremum_is_shown_on_the_mesh(tube):
    KNIT.add_time_constraint(points="[[0.02, 0.0, 0.03], [0.015, 0.0125, 0.03]]", time=1.0)
    tube.data.meshknit.constraints[1].time = 0.2  # the end is earlier than the middle now
    index, problem = findings()["false-extremum"]
    assert KNIT.select_finding(index=index) == {"FINISHED"}
    tube.update_from_editmode()
    heights = [v.co.z for v in tube.data.vertices if v.select]
    assert heights and all(0.01 < z < 0.05 for z in heights)


def test_a_bend_has_short_rows_ahead_where_it_is_slow():
    KNIT.add_bent_tube()
    ob = bpy.context.object
    index, problem = findings()["short-rows-ahead"]
    KNIT.select_finding(index=index)
    ob.update_from_editmode()
    chosen = [p.center for p in ob.data.polygons if p.select]
    assert 0 < len(chosen) < len(ob.data.polygons)


def test_saddles_say_what_happens_there():
    KNIT.add_trousers()
    settle()
    (saddle,) = session().guidance.saddles
    assert (saddle.below, saddle.above) == (1, 2) and saddle.text() == "splits into 2"
    KNIT.add_two_way_merge()
    settle()
    assert [s.text() for s in session().guidance.saddles] == ["2 merge into one"]


def test_an_object_that_is_wider_than_the_bed_is_told_of():
    KNIT.add_straight_tube(radius=400.0, length=60.0)
    bpy.context.scene.meshknit.live_graph = False
    # 2 pi 400 / 3.66 = 687 stitches round: more than 540 needles hold at half gauge.
    assert "wider-than-the-bed" in findings()


def test_a_profile_with_a_mistake_is_named(tube, tmp_path):
    mine = tmp_path / "mine.json"
    mine.write_text('{"based_on": "kniterate", "nedles": 300}')
    bpy.context.scene.meshknit.machine_file = str(mine)
    assert '"nedles"' in findings()["not-judged"][1]["message"]
    assert session().is_fresh("graph")  # which needs no machine


def test_a_profile_that_is_gone_is_named_until_it_is_there(tube):
    settle()
    bpy.context.scene.meshknit.machine_file = "/nowhere/mine.json"
    settle()
    assert "/nowhere/mine.json" in session().untold() and session().stale_stages()
    bpy.context.scene.meshknit.machine_file = ""
    settle()
    assert session().untold() == "" and session().stale_stages() == []


def test_a_closed_mesh_is_offered_a_suggestion():
    add_mesh(*meshes.ball(radius=40.0))
    with pytest.raises(RuntimeError, match="closed"):
        KNIT.check_mesh()
    found = findings()
    assert any("SUGGEST" in problem["actions"] for _, problem in found.values())
    KNIT.suggest()
    assert not any(p["severity"] == "error" for _, p in findings().values())


def test_old_findings_are_not_acted_on(tube):
    KNIT.remove_constraint(index=1)
    index, _ = findings()["boundary-without-time"]
    tube.data.meshknit.constraints[0].time = -0.3
    from meshknit.scene import live

    live.tick()
    with pytest.raises(RuntimeError, match="changed since"):
        KNIT.give_time(index=index)


def test_a_painted_pit_is_mended_by_a_click(tube):
    KNIT.solve_time()
    painted = read_attribute(tube.data, "knit_time", "FLOAT", "POINT")
    pit = len(painted) // 2
    painted[pit] -= 0.5
    write_attribute(tube.data, "knit_time", "FLOAT", "POINT", painted)
    tube.data.meshknit.time_source = "ATTRIBUTE"
    _, problem = findings()["false-extremum"]
    assert problem["actions"][0] == "MEND"
    assert KNIT.mend_time() == {"FINISHED"}
    assert "false-extremum" not in findings()
    mended = read_attribute(tube.data, "knit_time", "FLOAT", "POINT")
    changed = np.flatnonzero(np.abs(mended - painted) > 1e-5)
    assert changed.tolist() == [pit], "nothing else was wrong"


def test_times_of_constraints_are_not_mended(tube):
    with pytest.raises(RuntimeError, match="constraint"):
        KNIT.mend_time()
