"""Suggest: openings and times of a mesh without marks, as --auto chooses them."""

import json
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest

import meshes
import meshknit
from meshknit.core.files import graph_text
from objects import add_mesh, session, times

KNIT = bpy.ops.meshknit
BATCH = Path(meshknit.__file__).with_name("batch.py")


def tube_with_boundaries():
    return meshes.tube(radius=30.0, length=90.0)


def egg():
    """Closed, and longer than wide."""
    vertices, polygons = meshes.ball(radius=40.0)
    return vertices * (1.0, 1.0, 1.6), polygons


@pytest.mark.parametrize("make", [egg, tube_with_boundaries])
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_the_operator_gives_the_graph_that_auto_gives(make, turn, tmp_path):
    ob = add_mesh(*make())
    # Not where single precision is exact.
    ob.rotation_euler, ob.location, ob.scale = (turn, 0.3 * turn, 0.1), (0.1, 0.2, 0.3), (1, 1, 1.1)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    assert KNIT.suggest() == {"FINISHED"}
    assert KNIT.build_graph() == {"FINISHED"}
    by_operator = graph_text(session().value("graph"))
    command = [bpy.app.binary_path, "--background", str(tmp_path / "scene.blend"), "--python"]
    command += [str(BATCH), "--", "--auto", "--until", "graph", "--quiet"]
    command += ["--graph", str(tmp_path / "graph.json")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "graph.json").read_text() == by_operator


def test_a_suggestion_takes_the_place_of_the_marks_and_can_be_edited(tube):
    KNIT.add_opening(location=(0.02, 0.0, 0.03), radius=5.0, time=0.3)
    mesh = tube.data
    assert len(mesh.meshknit.openings) == 1
    assert KNIT.suggest() == {"FINISHED"}
    assert len(mesh.meshknit.openings) == 0 and sorted(times(tube)) == [-1.0, 1.0]
    mesh.meshknit.constraints[0].time = -0.8
    assert KNIT.solve_time() == {"FINISHED"}


def test_choices_are_the_three_of_the_list(tube):
    add_mesh(*egg())
    mesh = bpy.context.object.data
    seen = set()
    KNIT.suggest()
    found = session().suggestions
    for choice, entry in enumerate(found.entries):
        KNIT.suggest(choice=choice)
        assert session().suggestions is found  # not sought again
        assert found.applied == choice
        marks = [(tuple(o.location), round(o.time, 2)) for o in mesh.meshknit.openings]
        assert len(marks) == len(entry["openings"])
        seen.add(json.dumps(marks))
        KNIT.solve_time()  # every one of them is a field
        assert session().report["ok"]
    assert len(seen) == len(found.entries)
    if len(found.entries) < 3:
        with pytest.raises(RuntimeError, match="counted from 0"):
            KNIT.suggest(choice=2)


def test_one_undo_takes_a_suggestion_back(tube):
    bpy.ops.ed.undo_push(message="before")
    tube.data.meshknit.constraints[0].time = -0.25
    bpy.ops.ed.undo_push(message="time")
    KNIT.suggest()
    bpy.ops.ed.undo_push(message="suggest")
    bpy.ops.ed.undo()
    assert times(bpy.context.object) == [-0.25, 1.0]


def test_another_size_is_thought_about_anew(tube):
    add_mesh(*egg())
    KNIT.suggest()
    before = session().suggestions
    bpy.context.object.scale = (2.0, 2.0, 2.0)
    KNIT.suggest()
    assert session().suggestions is not before


def test_a_mesh_that_is_too_small_says_so():
    add_mesh(*meshes.ball(radius=6.0))
    with pytest.raises(RuntimeError, match="finer stitches"):
        KNIT.suggest()
    assert len(bpy.context.object.data.meshknit.openings) == 0


def test_a_profile_with_a_mistake_is_named(tube, tmp_path):
    mine = tmp_path / "mine.json"
    mine.write_text('{"based_on": "kniterate", "nedles": 300}')
    bpy.context.scene.meshknit.machine_file = str(mine)
    with pytest.raises(RuntimeError) as caught:
        KNIT.suggest()
    assert '"nedles"' in str(caught.value) and "Traceback" not in str(caught.value)


def test_in_edit_mode_too():
    ob = add_mesh(*egg())
    bpy.ops.object.mode_set(mode="EDIT")
    assert KNIT.suggest() == {"FINISHED"}
    assert ob.mode == "EDIT" and len(ob.data.meshknit.openings) >= 2


def test_openings_lie_on_the_tips_of_the_egg():
    ob = add_mesh(*egg())
    KNIT.suggest()
    heights = sorted(opening.location[2] for opening in ob.data.meshknit.openings)
    np.testing.assert_allclose(heights, [-0.064, 0.064], atol=0.004)
