"""Arrays for drawing, without gpu."""

from dataclasses import dataclass

import numpy as np

from ..core import colors

THIN = ("column", "row")
THICK = ("short row", "increase", "decrease")
KINDS = THIN + THICK
COLORS = {
    "column": colors.COLUMN,
    "row": colors.ROW,
    "short row": colors.SHORT_ROW,
    "increase": colors.INCREASE,
    "decrease": colors.DECREASE,
}
LEGEND = (
    ("row", "Row"),
    ("column", "Column"),
    ("short row", "Short row"),
    ("increase", "Increase: one stitch becomes two"),
    ("decrease", "Decrease: two stitches become one"),
)


STAR = 0.35  # arm of a star, in stitch widths


@dataclass(frozen=True)
class Lines:
    """Segments as pairs of points, with one colour per point."""

    points: np.ndarray  # (2 n, 3) float32
    colors: np.ndarray  # (2 n, 4) float32


def graph_edges(graph):
    """The knit graph's edges by kind: (n, 2) node pairs for each of KINDS."""
    rows, short = graph.row_edges
    columns = np.asarray(graph.columns).reshape(-1, 2)
    count = len(graph.nodes)
    increases = np.bincount(columns[:, 0], minlength=count)[columns[:, 0]] > 1
    decreases = np.bincount(columns[:, 1], minlength=count)[columns[:, 1]] > 1
    return {
        "column": columns[~increases & ~decreases],
        "row": rows[~short],
        "short row": rows[short],
        "increase": columns[increases],
        "decrease": columns[decreases & ~increases],
    }


def graph_lines(graph, scale, stale=False):
    """The knit graph in scene units (`scale`: mm per unit). -> (thin lines: rows and columns, thick
    lines: short rows and shaping, with a star where a stitch becomes two or two become one).
    A stale graph is grey all over."""
    places = graph.nodes[:, :3] / scale
    edges = graph_edges(graph)
    arm = STAR * graph.stitch_width / scale
    stars = {
        "increase": _stars(places[np.unique(edges["increase"][:, 0])], arm),
        "decrease": _stars(places[np.unique(edges["decrease"][:, 1])], arm),
    }
    parts = {kind: places[edges[kind].ravel()] for kind in KINDS}
    for kind, points in stars.items():
        parts[kind] = np.concatenate([parts[kind], points])
    return _lines(parts, THIN, stale), _lines(parts, THICK, stale)


def _lines(parts, kinds, stale):
    shades = [
        np.tile(np.float32(colors.STALE if stale else COLORS[kind]), (len(parts[kind]), 1))
        for kind in kinds
    ]
    points = np.concatenate([parts[kind] for kind in kinds])
    return Lines(points.astype(np.float32), np.concatenate(shades))


def _stars(places, arm):
    """Three crossing segments at each place, seen as a star from everywhere."""
    arms = arm * np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]])
    return (places[:, None, :] + arms[None]).reshape(-1, 3)


def marked_lines(segments, marks, times):
    """Segments (n, 2, 3) of constraints, each in the colour of its time. `marks` names the
    constraint of each, from 1."""
    shades = colors.time_colors(np.asarray(times, float))[np.asarray(marks, int) - 1]
    points = np.asarray(segments, np.float32).reshape(-1, 3)
    return Lines(points, np.repeat(shades, 2, axis=0))


def chain_lines(points, shade):
    """A chain of points in one colour."""
    pairs = np.stack([points[:-1], points[1:]], axis=1).reshape(-1, 3)
    return Lines(pairs.astype(np.float32), np.tile(np.float32(shade), (len(pairs), 1)))


def in_color(lines, shade):
    return Lines(lines.points, np.tile(np.float32(shade), (len(lines.points), 1)))


def ring_lines(rings, stale=False):
    """Closed polygons, each (n, 3), as lines in the colour of rims."""
    pairs = [np.stack([ring, np.roll(ring, -1, axis=0)], axis=1).reshape(-1, 3) for ring in rings]
    points = np.concatenate(pairs) if pairs else np.empty((0, 3))
    shade = np.float32(colors.STALE if stale else colors.RIM)
    return Lines(points.astype(np.float32), np.tile(shade, (len(points), 1)))


@dataclass(frozen=True)
class Triangles:
    """A coloured surface in the object's own space."""

    points: np.ndarray  # (n, 3) float32
    colors: np.ndarray  # (n, 4) float32
    indices: np.ndarray  # (m, 3) int32


def time_triangles(points, shades, indices, stale=False):
    """The time field as coloured triangles; a stale one is half grey."""
    shades = np.array(shades, dtype=np.float32)
    if stale:
        shades[:, :3] = 0.75 * shades[:, :3].mean(axis=1, keepdims=True) + 0.25 * shades[:, :3]
    return Triangles(
        np.ascontiguousarray(points, np.float32), shades, np.ascontiguousarray(indices, np.int32)
    )
