"""What is drawn: lines of the knit graph by kind, and time colours."""

import numpy as np

from meshknit.core import colors
from meshknit.overlay import overlay_data


class Graph:
    """Two rows of three and a short row: node 0 is increased, node 5 is decreased."""

    stitch_width = 3.66
    nodes = np.array([[1000.0 * i, 0, 0, 0.1 * i] for i in range(8)])
    columns = np.array([[0, 3], [0, 4], [1, 5], [2, 5], [3, 6], [4, 7]])
    row_edges = (np.array([[0, 1], [1, 2], [3, 4], [4, 5], [6, 7]]), np.array([False] * 4 + [True]))


def test_every_edge_is_drawn_once_and_by_its_kind():
    edges = overlay_data.graph_edges(Graph())
    assert edges["increase"].tolist() == [[0, 3], [0, 4]]
    assert edges["decrease"].tolist() == [[1, 5], [2, 5]]
    assert edges["column"].tolist() == [[3, 6], [4, 7]]
    assert edges["short row"].tolist() == [[6, 7]]
    assert len(edges["row"]) == 4


def test_lines_are_in_scene_units_and_stale_ones_are_grey():
    thin, thick = overlay_data.graph_lines(Graph(), scale=1000.0)
    stars = 2  # of three segments each: one increase, one decrease
    assert len(thin.points) == 2 * (2 + 4)
    assert len(thick.points) == 2 * (4 + 1 + 3 * stars)
    assert thick.points.dtype == np.float32 and thick.points[:, 0].max() == 7.0
    assert len(np.unique(thick.colors, axis=0)) == 3
    thin, thick = overlay_data.graph_lines(Graph(), scale=1000.0, stale=True)
    assert len(np.unique(np.concatenate([thin.colors, thick.colors]), axis=0)) == 1


def test_early_is_blue_late_is_red_unknown_is_grey():
    early, middle, late, unknown = colors.time_colors([-1.0, 0.0, 1.0, np.nan])
    assert early[2] > 2 * early[0] and late[0] > 2 * late[2]
    assert middle[:2].min() > 0.9
    assert unknown[0] == unknown[1] == unknown[2]
