"""Where rows of the present gauge would lie on a time field, before any row is knit."""

import numpy as np

BANDS = 256  # of equal time, by which a field's steepness is known
MOST_FACES = 40_000  # that are looked at: more of them say no more about a band
NARROWEST = 1e-3  # of a band: what a face of one time is taken to span


class FieldGeometry:
    """What the steps of all fields on a surface share: areas and edge vectors of its faces."""

    def __init__(self, vertices, faces):
        faces = faces[:: 1 + len(faces) // MOST_FACES]
        corners = np.asarray(vertices, np.float64)[faces]
        second, third = corners[:, 2] - corners[:, 0], corners[:, 0] - corners[:, 1]
        self._faces = np.ascontiguousarray(faces)
        self._products = [(a * b).sum(axis=1) for a, b in
                          ((second, second), (second, third), (third, third))]  # fmt: skip
        normals = np.cross(second, third)
        self._areas = 0.5 * np.sqrt((normals * normals).sum(axis=1))

    def row_numbers(self, times, row_height):
        """For each vertex, how many rows of this height (mm) lie below it; 0 at the lowest time.

        Rows are level sets, each its height above the one below it: time over the mean slope of
        the field along the level set. By the coarea formula the mean slope in a band is the
        integral of its square over that of the slope itself, both over the band's area."""
        times = np.asarray(times, np.float64)
        low, high = times.min(), times.max()
        if not high > low:
            return np.zeros(len(times))
        band = (high - low) / BANDS
        at = (times - low) / band
        a, b, c = (at[self._faces[:, k]] for k in range(3))
        from_first, to_third = b - a, c - a
        # 4 A^2 of the squared slope, in bands a millimetre.
        squares = (
            from_first * from_first * self._products[0]
            + 2.0 * from_first * to_third * self._products[1]
            + to_third * to_third * self._products[2]
        )
        squares = np.maximum(squares, 0.0)
        begins, ends = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        slope = _spread(0.5 * np.sqrt(squares), begins, ends)
        with np.errstate(divide="ignore", invalid="ignore"):
            square = np.where(self._areas > 0.0, 0.25 * squares / self._areas, 0.0)
        flow = _spread(square, begins, ends)
        steps = np.divide(slope, flow, out=np.zeros(BANDS), where=flow > 0.0)
        heights = np.concatenate([[0.0], np.cumsum(steps)])
        return np.interp(at, np.arange(BANDS + 1), heights / row_height)


def _spread(amounts, begins, ends):
    """Amounts that are spread evenly from where they begin to where they end -> what each of the
    bands [0, 1], [1, 2], ... gets of them."""
    ends = np.maximum(ends, begins + NARROWEST)
    rates = amounts / (ends - begins)
    sums = np.zeros(BANDS + 1)
    numbers = np.arange(BANDS + 1)
    # What has begun adds its rate times the way since then; what has ended takes it off again.
    for places, sign in ((begins, 1.0), (ends, -1.0)):
        next_number = np.minimum(places.astype(np.int64) + 1, BANDS + 1)
        rate = np.cumsum(np.bincount(next_number, rates, BANDS + 2))[: BANDS + 1]
        moment = np.cumsum(np.bincount(next_number, rates * places, BANDS + 2))[: BANDS + 1]
        sums += sign * (numbers * rate - moment)
    return np.diff(sums)
