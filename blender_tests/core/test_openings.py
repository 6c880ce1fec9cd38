"""Openings through the stages: cut, named, timed, reported."""

import math
from dataclasses import replace

import numpy as np
import pytest

import meshes
from meshknit import native
from meshknit.core.model import Constraint, Model, Opening
from meshknit.core.report import build_report
from meshknit.core.settings import Settings
from meshknit.core.workflow import run_stages, stage_keys

library = native.load()
SETTINGS = Settings()
BOTTOM = Opening("Hem", -1.0, (0.0, 0.0, -50.0), 20.0)
TOP = Opening("Neck", 1.0, (0.0, 0.0, 50.0), 20.0)


def model_of(vertices, polygons, **more):
    triangles = [[p[0], p[i], p[i + 1]] for p in polygons for i in range(1, len(p) - 1)]
    source = [n for n, p in enumerate(polygons) for _ in range(len(p) - 2)]
    return Model(
        np.asarray(vertices, float), np.array(triangles, np.int32), face_source=np.array(source),
        **more,
    )  # fmt: skip


def ball(*openings, **more):
    return model_of(*meshes.ball(), openings=openings, **more)


def run(model, until="emit"):
    return run_stages(library, model, SETTINGS, until, library.RunContext())


def errors(outcome):
    return [p for p in outcome.problems if p["severity"] == "error"]


def test_a_ball_with_two_openings_is_knit_as_a_tube():
    model = ball(BOTTOM, TOP)
    outcome = run(model)
    assert outcome.ok, outcome.message
    report = build_report(library, model, SETTINGS, outcome)
    assert report["mesh"]["boundaries"] == 2 and report["mesh"]["vertices"] == len(model.vertices)
    assert report["check"]["ok"]
    hem, neck = report["openings"]
    assert (hem["name"], hem["time"], neck["time"]) == ("Hem", -1.0, 1.0)
    assert hem["at"] == [0.0, 0.0, -50.0] and hem["radius"] == 20.0
    # A circle of latitude 20 mm from the pole of a ball of 50 mm; this one has flat sides.
    circle = 2.0 * math.pi * 50.0 * math.sin(20.0 / 50.0)
    assert hem["rim_length"] == pytest.approx(circle, rel=0.02)
    assert hem["stitches"] == pytest.approx(circle / SETTINGS.stitch_width, abs=1)
    # The first row of the graph goes round the rim.
    graph = outcome.results["graph"].value
    assert graph.nodes[:, 2].min() == pytest.approx(-50.0 * math.cos(20.0 / 50.0), abs=1.0)


def test_the_field_comes_back_to_the_users_vertices():
    model = ball(BOTTOM, TOP)
    outcome = run(model, "time")
    times = outcome.results["check"].value.times_for_model(outcome.results["time"].value[0])
    heights = model.vertices[:, 2]
    assert len(times) == len(heights)
    # 20 mm along the surface from a pole are a height of 46.05 mm.
    assert (np.isnan(times) == (np.abs(heights) > 46.1)).all() and np.isnan(times).any()
    known = ~np.isnan(times)
    order = np.argsort(heights[known])
    assert (np.diff(times[known][order]) > -1e-3).all()


def test_without_a_time_the_opening_is_named():
    outcome = run(ball(BOTTOM, replace(TOP, time=None)))
    problem = next(p for p in errors(outcome) if p["code"] == "boundary-without-time")
    assert "Neck" in problem["message"] and "Hem" not in problem["message"]
    # Its elements are vertices of the user's ball, near the upper rim.
    vertices = problem["elements"]["vertices"]
    heights = meshes.ball()[0][vertices][:, 2]
    assert len(vertices) and (heights > 30.0).all()


def test_two_times_for_a_rim_are_told_with_their_sources():
    polygons = meshes.ball()[1]
    model = ball(replace(BOTTOM, at=None, radius=None, number=3), TOP)
    marked = np.isin(model.face_source, [i for i, p in enumerate(polygons) if 0 in p])
    ring = tuple(range(1, 25))  # the user's own vertices round the lower pole
    outcome = run(
        replace(
            model,
            face_marks=np.where(marked, 3, 0).astype(np.int32),
            constraints=(Constraint("Ring", ring, 0.5),),
        )
    )
    problem = next(p for p in errors(outcome) if p["code"] == "boundary-with-two-times")
    assert "Ring (0.5)" in problem["message"] and "Hem (-1)" in problem["message"]


def test_marked_faces_are_left_out_and_take_the_time_of_their_number():
    polygons = meshes.ball()[1]
    model = ball(Opening("Hem", -1.0, number=2), TOP)
    pole = [i for i, p in enumerate(polygons) if 0 in p]
    marked = np.isin(model.face_source, pole)
    model = replace(model, face_marks=np.where(marked, 2, 0).astype(np.int32))
    outcome = run(model, "graph")
    assert outcome.ok, outcome.message
    openings = build_report(library, model, SETTINGS, outcome)["openings"]
    assert [o["name"] for o in openings] == ["Neck", "Hem"]
    assert openings[1]["faces"] == pole and openings[1]["time"] == -1.0


def test_faces_marked_without_an_entry_take_a_time_from_a_constraint():
    polygons = meshes.ball()[1]
    model = ball(TOP)
    marked = np.isin(model.face_source, [i for i, p in enumerate(polygons) if 0 in p])
    model = replace(model, face_marks=np.where(marked, 7, 0).astype(np.int32))
    problem = next(p for p in errors(run(model)) if p["code"] == "boundary-without-time")
    assert "24 marked faces" in problem["message"]
    timed = replace(model, constraints=(Constraint("Ring", tuple(range(1, 25)), -1.0),))
    assert run(timed, "graph").ok


def test_a_field_of_the_users_own_is_cut_too():
    vertices, polygons = meshes.ball()
    own = vertices[:, 2] / 60.0
    model = ball(BOTTOM, TOP, own_time=own)
    outcome = run(model, "graph")
    assert outcome.ok, outcome.message
    knit = outcome.results["check"].value
    times = outcome.results["time"].value[0]
    for rim, time in zip(knit.rims, (-1.0, 1.0)):
        assert (times[list(rim.vertices)] == time).all()
    # Elsewhere the field is the height, also on the vertices that refining made.
    inner = np.ones(len(times), bool)
    inner[[v for rim in knit.rims for v in rim.vertices]] = False
    np.testing.assert_allclose(times[inner], knit.cut.vertices[inner, 2] / 60.0, atol=1e-6)


@pytest.mark.parametrize(
    "opening, code",
    [
        (replace(TOP, radius=1.0), "opening-too-small"),
        (replace(TOP, at=(0.0, 0.0, 500.0)), "opening-off-surface"),
        (replace(TOP, radius=400.0), "opening-swallows-part"),
        (replace(BOTTOM, radius=25.0), "openings-overlap"),
    ],
)
def test_what_cannot_be_cut_is_refused_with_faces_of_the_user(opening, code):
    model = ball(BOTTOM, opening)
    outcome = run(model)
    (problem,) = errors(outcome)
    assert problem["code"] == code and problem["remedy"]
    count = len(meshes.ball()[1])
    faces = problem["elements"].get("faces", [])
    assert all(0 <= f < count for f in faces) and (faces or code == "opening-off-surface")
    report = build_report(library, model, SETTINGS, outcome)
    assert report["ok"] is False and report["openings"] == []


def test_a_constraint_covers_the_vertices_that_cutting_made_on_its_edges():
    # A coarse square tube, its ends marked by their corners: the round opening in a side refines
    # the sides, and with them the edges of both ends.
    vertices, polygons = meshes.tube(radius=60.0, length=90.0, around=4, along=1)
    ends = [tuple(range(4)), tuple(range(4, 8))]
    constraints = [Constraint(str(i), end, t) for i, (end, t) in enumerate(zip(ends, (-1.0, 1.0)))]
    middle = vertices[[0, 1, 4, 5]].mean(axis=0)
    side = Opening("Thumb", None, tuple(middle), 30.0)
    model = model_of(vertices, polygons, openings=(side,), constraints=tuple(constraints))
    outcome = run(model, "time")
    assert len(outcome.results["check"].value.rows_of(ends[0])) > 8
    # Only the rim is without a time.
    (problem,) = [p for p in errors(outcome) if p["code"] == "boundary-without-time"]
    assert "Thumb" in problem["message"]


def test_a_changed_opening_changes_the_check_and_a_changed_time_the_field():
    model = ball(BOTTOM, TOP)
    keys = stage_keys(model, SETTINGS)
    wider = stage_keys(replace(model, openings=(replace(BOTTOM, radius=21.0), TOP)), SETTINGS)
    later = stage_keys(replace(model, openings=(replace(BOTTOM, time=-0.9), TOP)), SETTINGS)
    renamed = stage_keys(replace(model, openings=(replace(BOTTOM, name="x"), TOP)), SETTINGS)
    assert wider["check"] != keys["check"]
    assert later["check"] == keys["check"] and later["time"] != keys["time"]
    assert renamed == keys
