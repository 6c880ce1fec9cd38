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
    assert all(edge_chains.is_chain(edges, loop) for loop in loops)


def test_a_branching_selection_is_no_chain():
    edges = np.array([(0, 1), (1, 2), (1, 3)])
    assert not edge_chains.is_chain(edges, [0, 1, 2])
    assert edge_chains.is_chain(edges, [0, 1])


def test_shortest_path_runs_straight_up_the_tube():
    vertices, polygons = meshes.tube(around=24, along=6)
    edges, _ = edges_of(polygons)
    path = edge_chains.shortest_path(vertices, edges, [0, 6 * 24], closed=False)
    assert len(path) == 6  # one edge per ring
    assert (np.abs(vertices[edges[path]][:, :, :2] - vertices[0, :2]) < 1e-9).all()


def test_a_closed_path_comes_back_round_the_tube():
    vertices, polygons = meshes.tube(around=24, along=6)
    edges, _ = edges_of(polygons)
    stops = [72, 72 + 8, 72 + 16]
    path = edge_chains.shortest_path(vertices, edges, stops, closed=True)
    assert len(path) == 24
    assert len(edge_chains.shortest_path(vertices, edges, stops, closed=False)) == 16


def test_no_path_between_separate_parts():
    positions = np.array([(0, 0, 0), (1, 0, 0), (5, 0, 0), (6, 0, 0)], float)
    assert edge_chains.shortest_path(positions, np.array([(0, 1), (2, 3)]), [0, 3], False) is None
