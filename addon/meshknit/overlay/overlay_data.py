"""Arrays for drawing, without gpu."""

from dataclasses import dataclass

import numpy as np

from ..core import colors

KINDS = ("column", "row", "short row", "increase", "decrease")
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
    """The knit graph in scene units (`scale`: mm per unit). A stale graph is grey all over."""
    places = (graph.nodes[:, :3] / scale).astype(np.float32)
    edges = graph_edges(graph)
    points = [places[edges[kind].ravel()] for kind in KINDS]
    shades = []
    for kind, part in zip(KINDS, points):
        color = (*(colors.STALE if stale else COLORS[kind]), 0.35 if stale else 1.0)
        shades.append(np.tile(np.array(color, dtype=np.float32), (len(part), 1)))
    return Lines(np.concatenate(points), np.concatenate(shades))


@dataclass(frozen=True)
class Triangles:
    """A coloured surface in the object's own space."""

    points: np.ndarray  # (n, 3) float32
    colors: np.ndarray  # (n, 4) float32
    indices: np.ndarray  # (m, 3) int32


def time_triangles(points, shades, indices, stale=False):
    """The time field as coloured triangles; a stale one is half grey. `shades` are linear."""
    shades = np.array(shades, dtype=np.float32)
    if stale:
        shades[:, :3] = 0.75 * shades[:, :3].mean(axis=1, keepdims=True) + 0.25 * shades[:, :3]
    return Triangles(
        np.ascontiguousarray(points, np.float32), shades, np.ascontiguousarray(indices, np.int32)
    )
