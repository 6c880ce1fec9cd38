"""Chains of mesh edges, from edges as vertex pairs."""

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


def nearest_vertex(positions, point, among=None):
    """The vertex nearest to a point, of all or of some; the first of equals."""
    among = np.arange(len(positions)) if among is None else np.asarray(among)
    return int(among[np.argmin(((positions[among] - point) ** 2).sum(axis=1))])


def ordered_chain(edges, group):
    """-> (vertices in order, closed) of an open chain or a loop, from the end with the lower
    vertex; None where the group branches or falls apart."""
    neighbours = defaultdict(list)
    for row in group:
        a, b = (int(v) for v in edges[row])
        neighbours[a].append(b)
        neighbours[b].append(a)
    if not neighbours or max(map(len, neighbours.values())) > 2:
        return None
    ends = [v for v, others in neighbours.items() if len(others) == 1]
    chain = [min(ends or neighbours)]
    previous = None
    while True:
        onward = [v for v in sorted(neighbours[chain[-1]]) if v != previous]
        if not onward or onward[0] == chain[0]:
            break
        previous = chain[-1]
        chain.append(onward[0])
    if len(chain) != len(neighbours):
        return None
    return chain, not ends
