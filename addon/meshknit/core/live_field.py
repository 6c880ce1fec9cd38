"""The time field of a model that is being worked on: times change at the cost of a back-solve."""

from dataclasses import dataclass, field
from itertools import count
from typing import Optional

import numpy as np

from .knit_surface import KnitSurface
from .row_levels import FieldGeometry
from .workflow import run_stages

COURSES_IN_ROW = 2  # a row of the graph is two courses

_serials = count()


@dataclass(frozen=True, eq=False)
class KnitShape:
    """What does not change while constraints and times do."""

    knit: KnitSurface
    places: np.ndarray  # (n, 3) float32, in units of the scene
    faces: np.ndarray  # (m, 3) int32
    geometry: FieldGeometry
    weights: object  # library.FieldWeights
    serial: int = field(default_factory=lambda: next(_serials))  # of all shapes, this one


@dataclass(frozen=True, eq=False)
class LiveField:
    """A field of a model, for any times of its constraints and openings."""

    keys: dict  # of the model's stages
    scale: float  # mm per unit of the scene
    shape: KnitShape
    chains: tuple = ()  # rows of the surface that have one time
    # Of each chain: ("constraints" or "openings", entry of that list) or ("drawn", its time).
    sources: tuple = ()
    solver: Optional[object] = None  # library.LiveTimeField
    own_time: Optional[np.ndarray] = None

    def times(self, values):
        """The field, one time a vertex of the shape; `values` are the chains' times."""
        if self.own_time is not None:
            return np.asarray(self.own_time)
        times = np.asarray(self.solver.solve(list(values)))
        return np.nan_to_num(times, nan=min(values))  # of vertices that are in no face

    def rows(self, times, stitch_height):
        """How many rows of this gauge lie below each vertex."""
        return self.shape.geometry.row_numbers(times, COURSES_IN_ROW * stitch_height)


def make_live_field(library, model, settings, context, known=None, before=None):
    """-> (LiveField or None, outcome of the check). None where the surface has errors or nothing
    gives a time. `known` are results by stage; of `before`, a field, is kept what still holds. May
    run in any thread. Never throws for the model's faults or cancelling."""
    outcome = run_stages(library, model, settings, "check", context, known)
    if not outcome.ok:
        return None, outcome
    knit, keys = outcome.results["check"].value, outcome.keys
    chains, sources = _chains(knit, model)
    if model.own_time is None and model.source is None and not any(chains):
        return None, outcome
    same = before is not None and before.keys["check"] == keys["check"]
    shape = before.shape if same else _make_shape(library, model, knit)
    if model.own_time is not None:
        own = np.nan_to_num(np.asarray(knit.times_of(model), float))
        return LiveField(keys, model.scale, shape, own_time=own), outcome
    if model.source is not None:
        # These times are no back-solve away from others: they are found anew each time.
        found = run_stages(
            library, model, settings, "time", context, {**(known or {}), **outcome.results}
        )
        if not found.ok:
            return None, outcome
        own = np.asarray(found.results["time"].value[0])
        return LiveField(keys, model.scale, shape, own_time=own), outcome
    if same and before.chains == chains:
        solver = before.solver
    else:
        try:
            solver = library.LiveTimeField(shape.knit.surface, shape.weights, chains)
        except library.InvalidInput as error:
            outcome.status, outcome.message = "usage", str(error)
            return None, outcome
    return LiveField(keys, model.scale, shape, chains, sources, solver), outcome


def _make_shape(library, model, knit):
    vertices, faces = knit.arrays(model)
    return KnitShape(
        knit,
        np.ascontiguousarray(vertices / model.scale, np.float32),
        np.ascontiguousarray(faces, np.int32),
        FieldGeometry(vertices, faces),
        library.FieldWeights(knit.surface),
    )


def _chains(knit, model):
    """What gives a time -> (rows of the surface by chain, where the time of each comes from)."""
    found = []
    for constraint in model.constraints:
        rows = constraint.vertices if constraint.on_surface else knit.rows_of(constraint.vertices)
        listed = constraint.entry >= 0
        source = ("constraints", constraint.entry) if listed else ("drawn", constraint.time)
        found.append((rows, source))
    for rim in knit.rims:
        if rim.time(model) is not None:
            found.append((rim.vertices, ("openings", rim.opening)))
    chains, taken = [], set()
    for rows, _ in found:
        # The solver wants each vertex in one chain; what contradicts is found by the check.
        chains.append(tuple(int(row) for row in rows if row not in taken))
        taken.update(rows)
    return tuple(chains), tuple(source for _, source in found)
