"""What lies near the mouse: points and segments on the screen. Pixels count from the lower left."""

import numpy as np


def to_pixels(points, matrix, size):
    """(n, 3) world points -> ((n, 2) pixels, (n,) True where they are in front of the eye).
    `matrix` (4 x 4) leads to clip space, `size` is the region's width and height."""
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    depth = clip[:, 3]
    before = depth > 1e-9
    flat = clip[:, :2] / np.where(before, depth, 1.0)[:, None]
    return (flat + 1.0) * 0.5 * np.asarray(size, float), before


def near_segments(mouse, starts, ends, matrix, size, reach):
    """Segments that come within `reach` pixels of the mouse, the nearest first.
    -> [(row, place on the segment from 0 to 1), ...]"""
    if not len(starts):
        return []
    a, a_before = to_pixels(starts, matrix, size)
    b, b_before = to_pixels(ends, matrix, size)
    along = b - a
    squared = (along**2).sum(axis=1)
    at = ((mouse - a) * along).sum(axis=1) / np.where(squared > 0.0, squared, 1.0)
    at = np.clip(at, 0.0, 1.0)
    away = np.linalg.norm(a + at[:, None] * along - mouse, axis=1)
    away[~(a_before & b_before)] = np.inf
    order = np.argsort(away, kind="stable")
    return [(int(row), float(at[row])) for row in order[: (away <= reach).sum()]]
