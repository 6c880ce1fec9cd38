"""Stages run in order, once for the same inputs, and say why when they cannot."""

import threading
from dataclasses import replace

import numpy as np
import pytest

import meshes
from meshknit import native
from meshknit.core.job import Job
from meshknit.core.machines import Machine
from meshknit.core.marks import parse_marks, resolve_marks
from meshknit.core.model import Model
from meshknit.core.report import build_report
from meshknit.core.session import Session
from meshknit.core.settings import Settings
from meshknit.core.workflow import run_stages, stage_keys
from meshknit.names import STAGES

library = native.load()
SETTINGS = Settings()


def triangulated(polygons):
    return [[p[0], p[i], p[i + 1]] for p in polygons for i in range(1, len(p) - 1)]


def model_of(vertices, polygons, times=((-1.0, (0, 0, 0)), (1.0, (0, 0, 60)))):
    model = Model(np.asarray(vertices, float), np.array(triangulated(polygons), np.int32))
    surface = library.Surface(model.vertices, model.faces, SETTINGS.stitch_width)
    if not surface.ok:
        return model
    marks = parse_marks(meshes.marks(*times, units="mm"))
    return replace(model, constraints=resolve_marks(marks, surface, 1.0))


def run(model, until="emit", settings=SETTINGS, known=None, context=None):
    return run_stages(library, model, settings, until, context or library.RunContext(), known)


def codes(outcome):
    return [p["code"] for p in outcome.problems if p["severity"] == "error"]


def test_a_tube_goes_all_the_way():
    context = library.RunContext()
    outcome = run(model_of(*meshes.tube()), context=context)
    assert outcome.ok and list(outcome.results) == list(STAGES)
    assert outcome.results["emit"].value.text.startswith(";!knitout-2")
    assert context.progress == pytest.approx(1.0)


def test_a_run_stops_at_the_stage_asked_for():
    assert list(run(model_of(*meshes.tube()), "graph").results) == ["check", "time", "graph"]


def test_the_graphs_report_tells_how_long_edges_are_and_what_is_irregular():
    outcome = run(model_of(*meshes.tube()), "graph")
    report = build_report(library, model_of(*meshes.tube()), SETTINGS, outcome)["graph"]
    for kind in ("row_error", "column_error"):
        histogram = report[kind]["histogram"]
        # From -50 % to 50 % in steps of 5 %, and what lies beyond on either side.
        assert histogram["bounds"] == pytest.approx([-0.5 + 0.05 * k for k in range(21)])
        assert len(histogram["counts"]) == 22
        within = sum(histogram["counts"][9:13]) / sum(histogram["counts"])
        assert within == pytest.approx(report[kind]["within_10"], abs=0.01)
    assert sum(report["column_error"]["histogram"]["counts"]) == len(
        outcome.results["graph"].value.columns
    )
    assert report["short_row_ends"] == 2 * report["short_rows"]
    shaped = report["increases"] + report["decreases"] + report["short_row_ends"]
    assert report["irregular"] <= shaped


def test_evening_out_moves_stitches_and_adds_none_to_a_plain_tube():
    model = model_of(*meshes.tube())
    relaxed = run(model, "graph").results["graph"].value
    peeled = run(model, "graph", replace(SETTINGS, relax=False)).results["graph"].value
    np.testing.assert_array_equal(peeled.columns, relaxed.columns)
    assert np.abs(peeled.nodes - relaxed.nodes).max() > 1e-3


def test_known_results_are_not_computed_again():
    model = model_of(*meshes.tube())
    first = run(model, "graph")
    second = run(model, "trace", known=first.results)
    assert second.results["graph"].value is first.results["graph"].value


@pytest.mark.parametrize(
    "change, first_new",
    [
        (lambda m, s: (replace(m, vertices=m.vertices * 1.01), s), "check"),
        (lambda m, s: (replace(m, constraints=m.constraints[::-1]), s), "time"),
        (lambda m, s: (m, replace(s, stitch_height=2.0)), "graph"),
        (lambda m, s: (m, replace(s, relax=False)), "graph"),
        (lambda m, s: (m, replace(s, allow_seams=True)), "graph"),
        (lambda m, s: (m, replace(s, machine=Machine(changes=(("needles", 300),)))), "trace"),
    ],
)
def test_a_changed_input_changes_that_stage_and_all_later_ones(change, first_new):
    model = model_of(*meshes.tube())
    before, after = stage_keys(model, SETTINGS), stage_keys(*change(model, SETTINGS))
    changed = [stage for stage in STAGES if before[stage] != after[stage]]
    assert changed == list(STAGES[STAGES.index(first_new) :])


@pytest.mark.parametrize("shape", [meshes.disk, meshes.moebius, meshes.hourglass])
def test_what_is_no_tube_is_refused_with_a_sentence(shape):
    outcome = run(model_of(*shape()))
    assert outcome.status == "failed"
    assert codes(outcome) and outcome.message.count("\n") == 0 and len(outcome.message) > 20
    report = build_report(
        library, Model(*map(np.asarray, shape()[:1]), np.zeros((0, 3))), SETTINGS, outcome
    )
    assert report["ok"] is False and report["reason"] == outcome.message


def test_faces_are_named_as_the_users_polygons():
    vertices, polygons = meshes.tube()
    wrong = polygons + [polygons[0][:3] + [len(vertices)]]  # a third face on an edge
    model = model_of(np.vstack([vertices, [[60.0, 0.0, 5.0]]]), wrong)
    model = replace(model, face_source=np.arange(len(model.faces)) // 2)
    outcome = run(model)
    assert outcome.status == "failed"
    for problem in outcome.problems:
        assert all(f < len(wrong) for f in problem["elements"].get("faces", ()))


def test_contradictory_times_name_the_place():
    both = ((-1.0, (0, 0, 0)), (1.0, (0, 0, 60)), (0.5, (0, 0, 0)))
    outcome = run(model_of(*meshes.tube(), both))
    assert outcome.status == "failed"
    elements = outcome.problems[-1]["elements"]
    assert elements.get("vertices") or elements.get("boundaries")


def test_a_boundary_without_time_is_refused():
    outcome = run(model_of(*meshes.tube(), ((-1.0, (0, 0, 0)),)))
    assert "boundary-without-time" in codes(outcome)


def test_a_machine_that_is_too_narrow_says_what_fits():
    narrow = replace(SETTINGS, machine=Machine(changes=(("needles", 30),)))
    outcome = run(model_of(*meshes.tube()), settings=narrow)
    assert outcome.status == "failed" and "trace" in outcome.results
    # A row of 51 stitches where 30 needles at half gauge hold 12: at most 23 % of the size.
    assert "23 %" in outcome.message


def test_a_field_of_the_users_own_is_taken_as_it_is():
    vertices, polygons = meshes.tube()
    own = vertices[:, 2] / 30.0 - 1.0
    model = replace(model_of(vertices, polygons), constraints=(), own_time=own)
    outcome = run(model, "graph")
    assert outcome.ok
    np.testing.assert_array_equal(outcome.results["time"].value[0], own)


def test_a_bad_field_of_the_users_own_is_refused():
    vertices, polygons = meshes.tube()
    own = vertices[:, 2] / 30.0 - 1.0
    own[75] = 0.99  # a false maximum in the middle
    outcome = run(replace(model_of(vertices, polygons), own_time=own), "time")
    assert outcome.status == "failed"
    assert any(75 in p["elements"].get("vertices", ()) for p in outcome.problems)


def test_a_wrong_machine_field_is_wrong_usage():
    settings = replace(SETTINGS, machine=Machine(changes=(("nedles", 30),)))
    outcome = run(model_of(*meshes.tube()), settings=settings)
    assert outcome.status == "usage" and "nedles" in outcome.message


def test_cancelling_before_and_during_leaves_the_session_alone():
    model = model_of(*meshes.tube())
    session = Session()
    first = run(model, "graph")
    session.adopt(first, {"a": 1})
    context = library.RunContext()
    context.cancel()
    session.adopt(run(replace(model, scale=2.0), context=context), {})
    assert session.report == {"a": 1} and session.is_fresh("graph")

    started = threading.Event()

    def work(run_context):
        started.set()
        sock = library.sock()
        times = [(mark["time"], mark["boundary_near"]) for mark in sock["times"]]
        return run(model_of(sock["vertices"], sock["faces"], times), context=run_context)

    job = Job(work, library.RunContext())
    started.wait()
    job.cancel()
    job.wait(20.0)
    assert job.error is None and job.value.status == "cancelled"


def test_a_session_knows_what_is_stale():
    model = model_of(*meshes.tube())
    session = Session()
    session.adopt(run(model, "trace"), {})
    assert session.stale_stages() == []
    session.look_at(stage_keys(model, replace(SETTINGS, stitch_width=4.0)))
    assert session.stale_stages() == ["check", "time", "graph", "trace"]
    session.look_at(stage_keys(model, replace(SETTINGS, stitch_height=2.0)))
    assert session.stale_stages() == ["graph", "trace"]
    session.look_at(stage_keys(model, SETTINGS))
    assert session.stale_stages() == []
