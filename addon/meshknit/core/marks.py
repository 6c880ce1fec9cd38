"""Marks files (meshknit-marks-1): which places are knit when."""

import json
import math
from dataclasses import dataclass

from .errors import UsageError
from .model import Constraint

FORMAT = "meshknit-marks-1"


@dataclass(frozen=True)
class TimeMark:
    """One entry of `times`: a boundary near a point, or a chain through points."""

    time: float
    points: tuple
    is_boundary: bool
    closed: bool = False


@dataclass(frozen=True)
class Marks:
    in_model_units: bool
    times: tuple


def read_marks(path):
    """Throws UsageError for what is not a marks file, and for openings."""
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except (OSError, ValueError, RecursionError) as error:
        raise UsageError(f"cannot read the marks file {path}: {error}") from error
    try:
        return parse_marks(data)
    except UsageError as error:
        raise UsageError(f"marks file {path}: {error}") from error


def parse_marks(data):
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise UsageError(f'it must be an object whose "format" is "{FORMAT}"')
    units = data.get("units", "model")
    if units not in ("model", "mm"):
        raise UsageError('"units" must be "model" or "mm"')
    times = data.get("times")
    if not isinstance(times, list) or not times:
        raise UsageError('"times" must list at least one time')
    if data.get("openings") or any(isinstance(t, dict) and "opening" in t for t in times):
        raise UsageError("openings are not supported yet")
    return Marks(units == "model", tuple(_parse_time(i, t) for i, t in enumerate(times)))


def _parse_time(index, entry):
    where = f"times[{index}]"
    if not isinstance(entry, dict) or not _is_number(entry.get("time")):
        raise UsageError(f'{where} must have a number as its "time"')
    if not -1.0 <= entry["time"] <= 1.0:
        raise UsageError(f'{where}: "time" is {entry["time"]:g}, it must be from -1 to 1')
    if ("boundary_near" in entry) == ("points" in entry):
        raise UsageError(f'{where} must have either "boundary_near" or "points"')
    if "boundary_near" in entry:
        return TimeMark(float(entry["time"]), (_point(where, entry["boundary_near"]),), True)
    points = _points(where, entry["points"])
    closed = entry.get("closed", False)
    if not isinstance(closed, bool):
        raise UsageError(f'{where}: "closed" must be true or false')
    return TimeMark(float(entry["time"]), points, False, closed)


def parse_points(text):
    """A list of points as text, "[[x, y, z], ...]". Throws UsageError."""
    try:
        return _points("the list", json.loads(text))
    except (ValueError, RecursionError) as error:
        raise UsageError(f"points are written [[x, y, z], ...]: {error}") from error


def _points(where, points):
    if not isinstance(points, list) or not points:
        raise UsageError(f'{where}: "points" must list at least one point')
    return tuple(_point(where, p) for p in points)


def _point(where, value):
    if not isinstance(value, list) or len(value) != 3 or not all(map(_is_number, value)):
        raise UsageError(f"{where}: a point is a list of three numbers")
    return tuple(float(x) for x in value)


def _is_number(value):
    """What a double can hold: JSON as Python reads it also has NaN, Infinity and longer integers."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def resolve_marks(marks, surface, scale):
    """Marks -> constraints on a checked surface. Requires: the surface has a boundary."""
    factor = scale if marks.in_model_units else 1.0
    return tuple(_resolve(i, m, surface, factor) for i, m in enumerate(marks.times))


def _resolve(index, mark, surface, factor):
    points = [[x * factor for x in point] for point in mark.points]
    if mark.is_boundary:
        loop = surface.boundaries[surface.nearest_boundary(points[0])]
        vertices = loop["vertices"]
    else:
        vertices = [surface.nearest_vertex(point) for point in points]
        if len(vertices) > 1:
            vertices = surface.edge_path(vertices, mark.closed)
    return Constraint(f"times[{index}]", tuple(int(v) for v in vertices), mark.time)


def with_constraint_names(problem, constraints):
    """A problem whose message says which constraints give a boundary more than one time."""
    if problem["code"] != "boundary-with-two-times":
        return problem
    boundary = set(problem["elements"]["vertices"])
    found = [f"{c.name} ({c.time:g})" for c in constraints if boundary.intersection(c.vertices)]
    return {**problem, "message": f"{problem['message']} They come from {', '.join(found)}."}
