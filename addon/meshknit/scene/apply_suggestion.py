"""A suggestion becomes the marks of a mesh."""

import numpy as np

from .. import names
from ..core.errors import UsageError
from . import constraints, openings
from .attributes import read_attribute, write_attribute
from .read_model import mean_scale


def apply_suggestion(ob, entry, scale):
    """Puts openings and times in the place of those that are there; `entry` is in mm, `scale` in mm
    per unit of the scene. Requires Object Mode. Throws UsageError, and changes nothing then."""
    mesh, matrix = ob.data, np.array(ob.matrix_world, dtype=np.float64)
    rims = [
        (_rim(mesh, _to_local(matrix, mark["boundary_near"], scale)), mark["time"])
        for mark in entry["times"]
        if "boundary_near" in mark
    ]
    times = {mark["opening"]: mark["time"] for mark in entry["times"] if "opening" in mark}
    settings = getattr(mesh, names.PROPERTIES)
    _clear(mesh, settings)
    longer = mean_scale(matrix) * scale
    for index, opening in enumerate(entry["openings"]):
        place = _to_local(matrix, opening["at"], scale)
        openings.add_opening(mesh, place, opening["radius"] / longer, times.get(index))
    for index, (edges, time) in enumerate(rims):
        constraints.add_constraint(mesh, edges, time, f"Boundary {index + 1}")
    settings.active = settings.active_opening = 0


def _clear(mesh, settings):
    settings.time_source = "CONSTRAINTS"
    settings.constraints.clear()
    settings.openings.clear()
    for name, domain in ((names.CONSTRAINT, "EDGE"), (names.OPENING, "FACE")):
        marks = read_attribute(mesh, name, "INT", domain)
        if marks is not None and marks.any():
            write_attribute(mesh, name, "INT", domain, np.zeros_like(marks))


def _rim(mesh, place):
    loop = constraints.boundary_near(mesh, place)
    if loop is None:
        raise UsageError(names.MADE_BY_MODIFIER)
    return loop


def _to_local(matrix, place, scale):
    world = np.asarray(place, dtype=np.float64) / scale - matrix[:3, 3]
    return np.linalg.solve(matrix[:3, :3], world)
