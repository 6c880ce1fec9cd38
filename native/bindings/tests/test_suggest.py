"""Suggested set-ups, and fields judged before any row is knit."""

import numpy as np
import pytest

from meshknit import native

library = native.load()


def test_a_suggestion_is_a_set_of_marks():
    shape = library.example_shape("teddy")
    found = library.suggest_marks(shape["vertices"], shape["faces"])
    assert 1 <= len(found) <= 3
    best = found[0]
    assert len(best["times"]) == len(best["openings"]), "the teddy is closed"
    assert {-1.0, 1.0} <= {mark["time"] for mark in best["times"]}
    assert all(opening["radius"] > 0.0 for opening in best["openings"])
    assert "stitches" in best["summary"] and best["cost"]["fits"]


def test_a_field_is_judged_face_by_face():
    shape = library.example_shape("two_way_split")
    surface = library.Surface(shape["vertices"], shape["faces"], 3.66)
    chains = []
    for mark in shape["times"]:
        boundary = surface.boundaries[surface.nearest_boundary(mark["boundary_near"])]
        chains.append((boundary["vertices"], mark["time"]))
    times, _ = library.solve_time_field(surface, chains)
    guide = library.judge_field(surface, times)
    (saddle,) = guide["saddles"]
    assert (saddle["below"], saddle["above"]) == (1, 2)
    assert -1.0 < saddle["time"] < 1.0
    assert len(guide["slowness"]) == len(guide["slowness_faces"]) == len(shape["faces"])
    assert guide["slowness"].min() >= 1.0


def test_wrong_arguments_are_named():
    with pytest.raises(library.InvalidInput):
        library.suggest_marks(np.zeros((3, 3)), [[0, 1, 2]], stitch_width=0.0)
