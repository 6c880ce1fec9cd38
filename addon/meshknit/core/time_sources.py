"""Times that do not come from constraints alone: heights, distances, values of the user's own."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from .errors import UsageError

AXES = {
    "X": (0, 1.0),
    "Y": (1, 1.0),
    "Z": (2, 1.0),
    "-X": (0, -1.0),
    "-Y": (1, -1.0),
    "-Z": (2, -1.0),
}


@dataclass(frozen=True)
class TimeSource:
    """`kind` is DISTANCE, HEIGHT or VALUES (names.TIME_SOURCES)."""

    kind: str
    axis: str = "Z"  # for HEIGHT: the way the rows go
    values: Optional[np.ndarray] = None  # for VALUES: one a row of the model
    share: float = 1.0  # of this source; the rest is interpolated between the constraints
    mend: bool = True  # remove false extrema

    def key(self):
        """What a result depends on, for digest()."""
        return ("source", self.kind, self.axis, self.values, self.share, self.mend)


def sourced_times(library, knit, model, chains):
    """-> (one time per row of the surface, problems: what was mended). `chains` are (rows, time) of
    all that gives a time. Throws the library's NotKnittable for constraints that cannot be used, and
    UsageError."""
    source, surface = model.source, knit.surface
    if source.kind == "DISTANCE":
        times = library.distance_field(surface, _starts(surface, chains))
    elif source.kind == "HEIGHT":
        axis, sign = AXES[source.axis]
        vertices, _ = knit.arrays(model)
        times = library.field_from_values(surface, sign * np.asarray(vertices)[:, axis])
    else:
        times = library.field_from_values(surface, knit.values_of(model, source.values))
    if source.share < 1.0:
        harmonic, _ = library.solve_time_field(surface, chains)
        times = (1.0 - source.share) * harmonic + source.share * times
    if not source.mend:
        return times, []
    times, changed, most = library.mend_field(surface, times)
    return times, [_mended(changed, most)] if changed else []


def _starts(surface, chains):
    """The boundaries that hold the earliest time of all."""
    if not chains:
        raise UsageError("mark the boundary at which the distance begins with a time")
    earliest = min(time for _, time in chains)
    rows = {row for chain, time in chains if time == earliest for row in chain}
    starts = [
        index
        for index, boundary in enumerate(surface.boundaries)
        if rows.issuperset(boundary["vertices"])
    ]
    if not starts or len(starts) == len(surface.boundaries):
        raise UsageError(
            "the distance begins at the boundaries with the earliest time: give some boundaries that "
            "time, and not all"
        )
    return starts


def _mended(changed, most):
    places = "1 vertex" if changed == 1 else f"{changed} vertices"
    return {
        "code": "time-mended",
        "severity": "note",
        "message": f"The time was changed at {places}, by up to {most:.1%} of its range, so that "
        "knitting need not begin or end away from the openings.",
        "remedy": "",
        "elements": {},
    }
