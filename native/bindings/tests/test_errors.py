"""Errors reach Python as what they are, with problems that name elements."""

import numpy as np
import pytest

from meshknit import native

library = native.load()


def tube():
    return library.straight_tube(20.0, 40.0)


def test_a_model_that_cannot_be_knit_carries_its_problems():
    shape = tube()
    surface = library.Surface(shape["vertices"], shape["faces"])
    with pytest.raises(library.NotKnittable) as caught:
        library.solve_time_field(surface, [(surface.boundaries[0]["vertices"], -1.0)])
    problem = caught.value.problems[0]
    assert problem["severity"] == "error" and problem["message"] and problem["remedy"]


def test_a_hole_too_small_for_a_row_names_its_boundary_vertices():
    shape = tube()
    middle = len(shape["faces"]) // 2
    surface = library.Surface(shape["vertices"], np.delete(shape["faces"], middle, axis=0))
    assert len(surface.boundaries) == 3 and not surface.ok
    named = [p["elements"] for p in surface.problems if p["severity"] == "error"]
    assert any(e.get("boundaries") or e.get("vertices") for e in named)


@pytest.mark.parametrize(
    "vertices, faces",
    [
        (np.zeros((3, 2)), np.array([[0, 1, 2]])),
        (np.zeros((3, 3)), np.array([[0, 1]])),
        (np.zeros((3, 3)), np.array([[0, 1, 3]])),
    ],
)
def test_impossible_arrays_are_invalid_input(vertices, faces):
    with pytest.raises(library.InvalidInput):
        library.Surface(vertices, faces)


def test_broken_geometry_is_a_problem_and_no_exception():
    nothing = library.Surface(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert not nothing.ok and nothing.problems
    shape = tube()
    shape["vertices"][5] = np.nan
    surface = library.Surface(shape["vertices"], shape["faces"])
    assert any(5 in p["elements"].get("vertices", ()) for p in surface.problems)


def test_a_cancelled_run_stops():
    shape = tube()
    surface = library.Surface(shape["vertices"], shape["faces"])
    time = shape["vertices"][:, 2] / 20.0 - 1.0
    run = library.RunContext()
    run.cancel()
    with pytest.raises(library.Cancelled):
        library.build_knit_graph(surface, time, run=run)
    assert run.cancelled


def test_a_row_wider_than_the_bed_says_how_much_fits():
    shape = library.straight_tube(30.0, 30.0)
    surface = library.Surface(shape["vertices"], shape["faces"])
    profile = library.machine_profile("shima_swg091n2")
    profile.needles = 40
    graph = library.build_knit_graph(surface, shape["vertices"][:, 2] / 15.0 - 1.0)
    trace = library.trace(graph, profile)
    with pytest.raises(library.NotKnittable, match="%|size|wide"):
        library.schedule(trace, profile)
