"""Boundaries and chains of edges."""

import numpy as np

import meshes
from meshknit.core import edge_chains


def edges_of(polygons):
    """-> (edges, one edge per polygon corner)"""
    rows, corners = {}, []
    for polygon in polygons:
        for a, b in zip(polygon, polygon[1:] + polygon[:1]):
            corners.append(rows.setdefault((min(a, b), max(a, b)), len(rows)))
    return np.array(list(rows)), np.array(corners)


def test_a_tube_has_two_boundary_loops():
    _, polygons = meshes.tube(around=24)
    edges, corners = edges_of(polygons)
    loops = edge_chains.connected_groups(edges, edge_chains.boundary_edges(edges, corners))
    assert [len(loop) for loop in loops] == [24, 24]
    for first, loop in zip((0, 144), loops):
        assert edge_chains.ordered_chain(edges, loop) == (list(range(first, first + 24)), True)


def test_a_chain_is_ordered_from_its_lower_end():
    edges = np.array([(3, 1), (0, 3), (1, 2), (7, 8)])
    assert edge_chains.ordered_chain(edges, [0, 1, 2]) == ([0, 3, 1, 2], False)


def test_edges_that_branch_or_fall_apart_are_no_chain():
    edges = np.array([(0, 1), (1, 2), (1, 3), (4, 5), (5, 6), (6, 4)])
    assert edge_chains.ordered_chain(edges, [0, 1, 2]) is None
    assert edge_chains.ordered_chain(edges, [0, 3]) is None
    assert edge_chains.ordered_chain(edges, [0, 3, 4, 5]) is None  # a chain beside a loop
    assert edge_chains.ordered_chain(edges, []) is None
