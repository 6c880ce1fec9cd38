"""A field that is kept while times and chains change: the same as one that is solved anew."""

from dataclasses import replace

import numpy as np

import meshes
from meshknit import native
from meshknit.core.live_field import make_live_field
from meshknit.core.model import Constraint, Model, Opening
from meshknit.core.settings import Settings
from meshknit.core.workflow import run_stages

library = native.load()
SETTINGS = Settings()


def tube_model(*times):
    vertices, polygons = meshes.tube()
    faces = np.array([f for a, b, c, d in polygons for f in ((a, b, c), (a, c, d))], np.int32)
    rims = (range(24), range(len(vertices) - 24, len(vertices)))
    marks = tuple(
        Constraint(f"Rim {i}", tuple(rim), time, entry=i)
        for i, (rim, time) in enumerate(zip(rims, times))
    )
    return Model(np.array(vertices), faces, constraints=marks)


def field_of(model, before=None, known=None):
    return make_live_field(library, model, SETTINGS, library.RunContext(), known, before)


def solved(model):
    outcome = run_stages(library, model, SETTINGS, "time", library.RunContext())
    return outcome.results["time"].value[0]


def test_changed_times_give_the_field_of_the_stage():
    field, _ = field_of(tube_model(-1.0, 1.0))
    assert field.sources == (("constraints", 0), ("constraints", 1))
    for times in ((-1.0, 1.0), (-0.4, 0.9)):
        assert (field.times(times) == solved(tube_model(*times))).all()


def test_a_new_chain_keeps_surface_and_weights():
    model = tube_model(-1.0, 1.0)
    before, outcome = field_of(model)
    ring = Constraint("Ring", tuple(range(48, 72)), 0.5, entry=2)
    more = replace(model, constraints=(*model.constraints, ring))
    field, _ = field_of(more, before, outcome.results)
    assert field.shape is before.shape and field.solver is not before.solver
    assert (field.times((-1.0, 1.0, 0.5)) == solved(more)).all()
    again, _ = field_of(more, field, outcome.results)
    assert again.solver is field.solver


def test_an_opening_gives_its_time_to_its_rim():
    model = tube_model(-1.0, 1.0)
    hole = Opening("Hole", 0.5, (30.0, 0.0, 30.0), 8.0)
    field, _ = field_of(replace(model, openings=(hole,)))
    assert field.sources[-1] == ("openings", 0)
    times = field.times((-1.0, 1.0, 0.25))
    rim = list(field.shape.knit.rims[0].vertices)
    assert (times[rim] == 0.25).all()


def test_nothing_to_go_by_gives_no_field():
    field, outcome = field_of(tube_model())
    assert field is None and outcome.ok
    closed, polygons = meshes.ball()
    faces = [[p[0], p[i], p[i + 1]] for p in polygons for i in range(1, len(p) - 1)]
    field, outcome = field_of(Model(np.array(closed), np.array(faces, np.int32)))
    assert field is None and outcome.problems[0]["code"] == "too-few-boundaries"


def test_a_cancelled_field_is_none():
    context = library.RunContext()
    context.cancel()
    model = tube_model(-1.0, 1.0)
    field, outcome = make_live_field(library, model, SETTINGS, context)
    assert field is None and outcome.status == "cancelled"
