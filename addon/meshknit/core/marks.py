"""Marks files (meshknit-marks-1): where the surface is open, and which places are knit when."""

import json
import math
from dataclasses import dataclass, replace

from .errors import UsageError
from .model import Constraint, Opening

FORMAT = "meshknit-marks-1"


@dataclass(frozen=True)
class TimeMark:
    """An entry of `times` for a boundary near a point, or for a chain through points."""

    name: str
    time: float
    points: tuple
    is_boundary: bool
    closed: bool = False


@dataclass(frozen=True)
class Marks:
    in_model_units: bool
    times: tuple  # of TimeMark
    openings: tuple = ()  # of Opening, in the file's units


def read_marks(path):
    """Throws UsageError for what is not a marks file."""
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except OSError as error:
        raise UsageError(f"cannot read the marks file {path}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise UsageError(f"the marks file {path} is not JSON: {error}") from error
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
    openings = data.get("openings", [])
    if not isinstance(openings, list):
        raise UsageError('"openings" must be a list')
    openings = [_parse_opening(i, entry) for i, entry in enumerate(openings)]
    marks = []
    for index, entry in enumerate(times):
        where = f"times[{index}]"
        time = _parse_time(where, entry)
        if "opening" in entry:
            _give_time(openings, where, entry["opening"], time)
        else:
            marks.append(_parse_place(where, entry, time))
    return Marks(units == "model", tuple(marks), tuple(openings))


def _parse_opening(index, entry):
    where = f"openings[{index}]"
    if not isinstance(entry, dict) or "at" not in entry or not _is_number(entry.get("radius")):
        raise UsageError(f'{where} must have a point "at" and a number "radius"')
    if not entry["radius"] > 0.0:
        raise UsageError(f'{where}: "radius" is {entry["radius"]:g}, it must be above 0')
    return Opening(where, None, _point(where, entry["at"]), float(entry["radius"]))


def _parse_time(where, entry):
    if not isinstance(entry, dict) or not _is_number(entry.get("time")):
        raise UsageError(f'{where} must have a number as its "time"')
    if not -1.0 <= entry["time"] <= 1.0:
        raise UsageError(f'{where}: "time" is {entry["time"]:g}, it must be from -1 to 1')
    if sum(kind in entry for kind in ("opening", "boundary_near", "points")) != 1:
        raise UsageError(f'{where} must have one of "opening", "boundary_near" and "points"')
    return float(entry["time"])


def _give_time(openings, where, index, time):
    if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < len(openings):
        raise UsageError(f'{where}: "opening" must count from 0 in the list "openings"')
    if openings[index].time not in (None, time):
        raise UsageError(f"{where}: openings[{index}] has another time already")
    openings[index] = replace(openings[index], time=time)


def _parse_place(where, entry, time):
    if "boundary_near" in entry:
        return TimeMark(where, time, (_point(where, entry["boundary_near"]),), True)
    points = _points(where, entry["points"])
    closed = entry.get("closed", False)
    if not isinstance(closed, bool):
        raise UsageError(f'{where}: "closed" must be true or false')
    return TimeMark(where, time, points, False, closed)


def parse_points(text):
    """A list of points as text, "[[x, y, z], ...]". Throws UsageError."""
    try:
        return _points("the list", json.loads(text))
    except (ValueError, RecursionError) as error:
        raise UsageError(f"points are written [[x, y, z], ...]: {error}") from error


def parse_vertices(text):
    """A list of vertices as text, "[12, 40]". Throws UsageError."""
    try:
        rows = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UsageError(f"vertices are written [12, 40, ...]: {error}") from error
    whole = isinstance(rows, list) and all(type(row) is int for row in rows)
    if not whole or len(rows) < 2 or min(rows) < 0:
        raise UsageError("the vertices of a chain are at least two whole numbers from 0")
    return rows


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


def resolve_openings(marks, scale):
    """The openings of a marks file in millimetres."""
    factor = scale if marks.in_model_units else 1.0
    return tuple(
        replace(o, at=tuple(x * factor for x in o.at), radius=o.radius * factor)
        for o in marks.openings
    )


def resolve_marks(marks, surface, scale):
    """The times of places -> constraints on a checked surface. Requires: the surface has a
    boundary."""
    factor = scale if marks.in_model_units else 1.0
    return tuple(_resolve(m, surface, factor) for m in marks.times)


def _resolve(mark, surface, factor):
    points = [[x * factor for x in point] for point in mark.points]
    if mark.is_boundary:
        loop = surface.boundaries[surface.nearest_boundary(points[0])]
        vertices = loop["vertices"]
    else:
        vertices = [surface.nearest_vertex(point) for point in points]
        if len(vertices) > 1:
            vertices = surface.edge_path(vertices, mark.closed)
    return Constraint(mark.name, tuple(int(v) for v in vertices), mark.time, on_surface=True)
