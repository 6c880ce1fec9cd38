"""Marks files."""

import json
import math

import pytest

import meshes
from meshknit.core.errors import UsageError
from meshknit.core.marks import (
    parse_marks,
    parse_points,
    read_marks,
    resolve_marks,
    resolve_openings,
)

GOOD = meshes.marks((-1.0, (0, 0, 0)), (1.0, (0, 0, 1)))


class TubeSurface:
    """Stands for a surface with two boundaries: vertices 0-3 at z = 0 and 4-7 at z = 60."""

    boundaries = [{"vertices": [0, 1, 2, 3]}, {"vertices": [4, 5, 6, 7]}]

    def nearest_boundary(self, point):
        return 0 if point[2] < 30.0 else 1

    def nearest_vertex(self, point):
        return int(point[0])

    def edge_path(self, vertices, closed):
        return list(vertices) + ([99] if closed else [])


def test_points_are_in_the_files_own_units_unless_told():
    in_metres = meshes.marks((-1.0, (0, 0, 0.01)), (1.0, (0, 0, 0.05)))
    constraints = resolve_marks(parse_marks(in_metres), TubeSurface(), scale=1000.0)
    assert [c.vertices for c in constraints] == [(0, 1, 2, 3), (4, 5, 6, 7)]
    in_millimetres = meshes.marks((-1.0, (0, 0, 10)), (1.0, (0, 0, 50)), units="mm")
    assert resolve_marks(parse_marks(in_millimetres), TubeSurface(), 1000.0) == constraints


def test_points_become_a_chain():
    data = {**GOOD, "units": "mm"}
    data["times"] = [{"time": 0.2, "points": [[2, 0, 0], [6, 0, 0]], "closed": True}]
    (chain,) = resolve_marks(parse_marks(data), TubeSurface(), 1.0)
    assert chain.vertices == (2, 6, 99) and chain.time == 0.2


BALL = [{"at": [0, 0, -0.05], "radius": 0.02}, {"at": [0, 0, 0.05], "radius": 0.03}]


def test_openings_take_their_times_and_units_from_the_file():
    data = {**GOOD, "openings": BALL}
    data["times"] = [{"time": 1.0, "opening": 1}, {"time": -1.0, "opening": 0}]
    marks = parse_marks(data)
    assert marks.times == ()
    first, second = resolve_openings(marks, scale=1000.0)
    assert (first.name, first.time, second.time) == ("openings[0]", -1.0, 1.0)
    assert first.at == pytest.approx((0, 0, -50)) and second.radius == pytest.approx(30)
    in_millimetres = parse_marks({**data, "units": "mm"})
    assert resolve_openings(in_millimetres, 1000.0)[0].at == (0, 0, -0.05)


def test_an_opening_may_be_left_without_a_time():
    data = {**GOOD, "openings": BALL, "times": [{"time": 1.0, "opening": 1}]}
    assert [o.time for o in parse_marks(data).openings] == [None, 1.0]


def changed(**changes):
    return {**GOOD, **changes}


@pytest.mark.parametrize(
    "data, reason",
    [
        ([], "format"),
        (changed(format="meshknit-marks-2"), "format"),
        (changed(units="inch"), "units"),
        (changed(times=[]), "at least one time"),
        (changed(times=[{"boundary_near": [0, 0, 0]}]), r"times\[0\].*time"),
        (changed(times=[{"time": 0.1}]), "one of"),
        (changed(times=[{"time": 0.1, "boundary_near": [0, 0]}]), "three numbers"),
        (changed(times=[{"time": 0.1, "points": []}]), "at least one point"),
        (changed(times=[{"time": True, "boundary_near": [0, 0, 0]}]), "number"),
        (changed(times=5), "at least one time"),
        (changed(times=None), "at least one time"),
        (changed(times=[{"time": 10**400, "boundary_near": [0, 0, 0]}]), r"times\[0\].*number"),
        (changed(times=[{"time": math.nan, "boundary_near": [0, 0, 0]}]), r"times\[0\].*number"),
        (changed(times=[{"time": 0, "boundary_near": [0, 0, 10**400]}]), "three numbers"),
        (changed(times=[{"time": 0, "boundary_near": [0, 0, math.inf]}]), "three numbers"),
        (changed(times=[*GOOD["times"], {"time": 1.5, "points": [[0, 0, 0]]}]), r"times\[2\].*1.5"),
        (changed(openings={"at": [0, 0, 0], "radius": 8.0}), "must be a list"),
        (changed(openings=[{"at": [0, 0, 0]}]), r"openings\[0\].*radius"),
        (changed(openings=[BALL[0], {"at": [0, 0], "radius": 8.0}]), r"openings\[1\].*three"),
        (changed(openings=[{"at": [0, 0, 0], "radius": 0.0}]), r"openings\[0\].*above 0"),
        (changed(openings=[{"at": [0, 0, 0], "radius": math.nan}]), r"openings\[0\].*radius"),
        (changed(times=[{"time": 0, "opening": 0}]), r"times\[0\].*count from 0"),
        (changed(openings=BALL, times=[{"time": 0, "opening": -1}]), "count from 0"),
        (changed(openings=BALL, times=[{"time": 0, "opening": True}]), "count from 0"),
        (
            changed(openings=BALL, times=[{"time": t, "opening": 1} for t in (0.0, 0.5)]),
            r"times\[1\].*openings\[1\].*another time",
        ),
        (
            changed(openings=BALL, times=[{"time": 0, "opening": 0, "points": [[0, 0, 0]]}]),
            "one of",
        ),
    ],
)
def test_wrong_marks_are_refused_with_the_place(data, reason):
    with pytest.raises(UsageError, match=reason):
        parse_marks(data)


def test_a_file_that_is_no_json_is_refused(tmp_path):
    (tmp_path / "marks.json").write_text("{")
    with pytest.raises(UsageError, match="marks.json"):
        read_marks(tmp_path / "marks.json")
    (tmp_path / "marks.json").write_text(json.dumps(GOOD))
    assert len(read_marks(tmp_path / "marks.json").times) == 2


def test_json_nested_too_deep_is_refused(tmp_path):
    (tmp_path / "marks.json").write_text("[" * 100000)
    with pytest.raises(UsageError, match="marks.json"):
        read_marks(tmp_path / "marks.json")
    with pytest.raises(UsageError, match="points"):
        parse_points("[" * 100000)
