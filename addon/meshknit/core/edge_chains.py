"""Chains of mesh edges, from edges as vertex pairs."""

import heapq
from collections import defaultdict

import numpy as np


def boundary_edges(edges, polygon_edges):
    """Rows of `edges` that exactly one polygon uses. `polygon_edges` names an edge per corner."""
    uses = np.bincount(polygon_edges, minlength=len(edges))
    return np.flatnonzero(uses == 1)


def connected_groups(edges, chosen):
    """The chosen rows of `edges`, grouped by what hangs together; groups and rows ascend."""
    at_vertex = defaultdict(list)
    for row in chosen:
        for vertex in edges[row]:
            at_vertex[int(vertex)].append(int(row))
    groups, seen = [], set()
    for first in sorted(int(row) for row in chosen):
        if first in seen:
            continue
        seen.add(first)
        group, front = [], [first]
        while front:
            row = front.pop()
            group.append(row)
            for vertex in edges[row]:
                for other in at_vertex[int(vertex)]:
                    if other not in seen:
                        seen.add(other)
                        front.append(other)
        groups.append(sorted(group))
    return groups


def is_chain(edges, group):
    """True if the group is one open chain or one loop: nowhere do three edges meet."""
    _, degrees = np.unique(np.asarray(edges)[group], return_counts=True)
    return bool(degrees.max() <= 2)


def nearest_vertex(positions, point, among=None):
    """The vertex nearest to a point, of all or of some; the first of equals."""
    among = np.arange(len(positions)) if among is None else np.asarray(among)
    return int(among[np.argmin(((positions[among] - point) ** 2).sum(axis=1))])


def shortest_path(positions, edges, stops, closed):
    """Rows of `edges` that lead through the vertices `stops` in order; None if nothing does."""
    neighbours = defaultdict(list)
    lengths = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
    for row, (a, b) in enumerate(np.asarray(edges).tolist()):
        neighbours[a].append((b, row))
        neighbours[b].append((a, row))
    path = []
    legs = list(zip(stops, stops[1:])) + ([(stops[-1], stops[0])] if closed else [])
    for start, goal in legs:
        leg = _shortest_leg(neighbours, lengths, start, goal)
        if leg is None:
            return None
        path += leg
    return sorted(set(path))


def _shortest_leg(neighbours, lengths, start, goal):
    came, best, queue = {start: None}, {start: 0.0}, [(0.0, start)]
    while queue:
        distance, vertex = heapq.heappop(queue)
        if vertex == goal:
            rows = []
            while came[vertex] is not None:
                vertex, row = came[vertex]
                rows.append(row)
            return rows
        if distance > best[vertex]:
            continue
        for other, row in neighbours[vertex]:
            longer = distance + lengths[row]
            if longer < best.get(other, np.inf):
                best[other], came[other] = longer, (vertex, row)
                heapq.heappush(queue, (longer, other))
    return None
