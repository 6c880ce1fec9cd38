"""Time from heights, distances and values of the user's own."""

import bpy
import numpy as np
import pytest

import meshes
from meshknit.scene.attributes import write_attribute
from objects import add_mesh, heights, knit_time, session


@pytest.fixture
def bent():
    """A bent tube with a time at each end."""
    assert bpy.ops.meshknit.add_bent_tube() == {"FINISHED"}
    return bpy.context.object


@pytest.fixture
def tube():
    ob = add_mesh(*meshes.tube())
    for time in (-1.0, 1.0):
        bpy.ops.meshknit.add_boundary_constraint(time=time)
    return ob


def graph_report():
    return session().report["graph"]


def test_distance_has_fewer_short_rows_than_constraints(bent):
    assert bpy.ops.meshknit.build_graph() == {"FINISHED"}
    interpolated = graph_report()["short_rows"]
    bent.data.meshknit.time_source = "DISTANCE"
    assert bpy.ops.meshknit.build_graph() == {"FINISHED"}
    assert graph_report()["short_rows"] < interpolated
    assert session().report["time_field"]["source"] == "distance"


def test_height_runs_along_the_chosen_axis(tube):
    settings = tube.data.meshknit
    settings.time_source = "HEIGHT"
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    upward = knit_time(tube)
    assert np.corrcoef(upward, heights(tube))[0, 1] > 0.999
    settings.time_axis = "-Z"
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    assert np.allclose(knit_time(tube), -upward, atol=1e-6)


def test_values_come_from_an_attribute_or_a_vertex_group(tube):
    settings = tube.data.meshknit
    settings.time_source, settings.time_values = "VALUES", "painted"
    values = heights(tube) ** 2
    write_attribute(tube.data, "painted", "FLOAT", "POINT", values.astype(np.float32))
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    from_attribute = knit_time(tube)
    assert from_attribute.min() == -1.0 and from_attribute.max() == 1.0
    assert (np.diff(from_attribute[np.argsort(heights(tube), kind="stable")]) > -1e-6).all()
    tube.data.attributes.remove(tube.data.attributes["painted"])
    group = tube.vertex_groups.new(name="painted")
    for index, value in enumerate(values / values.max()):
        group.add([index], float(value), "REPLACE")
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    assert np.allclose(knit_time(tube), from_attribute, atol=1e-4)


def test_values_that_are_not_there_are_named(tube):
    tube.data.meshknit.time_source, tube.data.meshknit.time_values = "VALUES", "nothing"
    with pytest.raises(RuntimeError, match="nothing"):
        bpy.ops.meshknit.solve_time()


def test_a_share_lies_between_both(tube):
    settings = tube.data.meshknit
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    interpolated = knit_time(tube)
    write_attribute(tube.data, "painted", "FLOAT", "POINT", (heights(tube) ** 2).astype(np.float32))
    settings.time_source, settings.time_values = "VALUES", "painted"
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    painted = knit_time(tube)
    settings.time_share = 0.5
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    assert np.allclose(knit_time(tube), 0.5 * (interpolated + painted), atol=1e-5)


def test_a_pit_is_mended_or_named(tube):
    settings = tube.data.meshknit
    values = heights(tube)
    values[len(values) // 2] -= 0.5 * np.ptp(values)
    write_attribute(tube.data, "painted", "FLOAT", "POINT", values.astype(np.float32))
    settings.time_source, settings.time_values = "VALUES", "painted"
    settings.time_mend = False
    with pytest.raises(RuntimeError, match="away from the openings"):
        bpy.ops.meshknit.solve_time()
    settings.time_mend = True
    assert bpy.ops.meshknit.solve_time() == {"FINISHED"}
    assert "time-mended" in [p["code"] for p in session().report["problems"]]


def test_distance_needs_a_boundary_to_begin_at(tube):
    tube.data.meshknit.time_source = "DISTANCE"
    while tube.data.meshknit.constraints:
        bpy.ops.meshknit.remove_constraint()
    with pytest.raises(RuntimeError, match="boundary"):
        bpy.ops.meshknit.solve_time()
