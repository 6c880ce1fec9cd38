"""Time constraints on a mesh: a list of names and times, and an edge attribute that says where.
All of this needs Object Mode."""

import numpy as np

from .. import names
from ..core import edge_chains
from ..core.errors import UsageError
from .attributes import (
    edge_vertices,
    polygon_edges,
    positions,
    read_attribute,
    to_world,
    write_attribute,
)


def constraint_marks(mesh):
    """One number per edge: 0, or 1 + the index of its constraint."""
    marks = read_attribute(mesh, names.CONSTRAINT, "INT", "EDGE")
    return np.zeros(len(mesh.edges), np.int32) if marks is None else marks


def add_constraint(mesh, edges, time, name=None):
    """Edges that another constraint had go over to this one; one that loses its last edge so is
    removed. -> the new constraint's index"""
    settings = getattr(mesh, names.PROPERTIES)
    index = len(settings.constraints)
    entry = settings.constraints.add()
    entry.name, entry.time = name or f"Constraint {index + 1}", time
    return redraw_constraint(mesh, index, edges)


def redraw_constraint(mesh, index, edges):
    """The constraint is on these edges from now on. -> its index, which is a new one where others
    have lost their last edge"""
    settings = getattr(mesh, names.PROPERTIES)
    marks = constraint_marks(mesh)
    before = set(np.unique(marks).tolist())
    marks[marks == index + 1] = 0
    marks[np.asarray(edges, dtype=int)] = index + 1
    write_attribute(mesh, names.CONSTRAINT, "INT", "EDGE", marks)
    lost = before - set(np.unique(marks).tolist()) - {0, index + 1}
    for mark in sorted(lost, reverse=True):
        remove_constraint(mesh, mark - 1)
    index -= sum(mark - 1 < index for mark in lost)
    settings.active = index
    return index


def remove_constraint(mesh, index):
    """Later constraints move up by one, in the list and on the edges."""
    settings = getattr(mesh, names.PROPERTIES)
    marks = constraint_marks(mesh)
    marks[marks == index + 1] = 0
    marks[marks > index + 1] -= 1
    write_attribute(mesh, names.CONSTRAINT, "INT", "EDGE", marks)
    settings.constraints.remove(index)
    settings.active = max(0, min(settings.active, len(settings.constraints) - 1))


def edges_of_constraint(mesh, index):
    """-> rows of edge_vertices()"""
    return np.flatnonzero(constraint_marks(mesh) == index + 1)


def boundary_loops(mesh):
    """The mesh's boundary edges by loop."""
    edges = edge_vertices(mesh)
    rows = edge_chains.boundary_edges(edges, polygon_edges(mesh))
    return edge_chains.connected_groups(edges, rows)


def loops_without_constraint(mesh):
    marks = constraint_marks(mesh)
    return [loop for loop in boundary_loops(mesh) if not marks[loop].any()]


def boundary_near(mesh, point):
    """The boundary loop whose vertex is nearest to a point in the object's own space, or None."""
    loops, edges, at = boundary_loops(mesh), edge_vertices(mesh), positions(mesh)
    if not loops:
        return None
    vertex = edge_chains.nearest_vertex(
        at, np.asarray(point), np.unique(edges[np.concatenate(loops)])
    )
    return next(loop for loop in loops if (edges[loop] == vertex).any())


def path_through(library, mesh, stops, closed, matrix):
    """Edges of the shortest way through vertices in order. `matrix` is the object's: the way is
    the shortest as it stands in the world. Throws UsageError if there is none."""
    at = to_world(positions(mesh), matrix)
    if not all(0 <= stop < len(at) for stop in stops):
        raise UsageError(f"The mesh has no vertex {max(stops)}: it has {len(at)}")
    graph = library.EdgeGraph(at, edge_vertices(mesh))
    chain = list(stops[:1])
    for stop in (*stops[1:], *stops[: 1 if closed else 0]):
        leg = graph.path(chain[-1], stop)
        if not leg:
            raise UsageError(f"No edges lead from vertex {chain[-1]} to vertex {stop}")
        chain += leg[1:]
    if len(chain) < 2:
        raise UsageError("The places lie at one vertex: a chain needs an edge")
    return sorted(set(graph.edges_along(chain)))


def seam_chains(mesh):
    """The edges that are marked as UV seams, by what hangs together."""
    seams = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("use_seam", seams)
    return edge_chains.connected_groups(edge_vertices(mesh), np.flatnonzero(seams))


def selected_edges(mesh):
    chosen = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("select", chosen)
    return np.flatnonzero(chosen)


def selected_chain(mesh):
    """The selected edges. Throws UsageError if they are not one chain or loop."""
    chosen, edges = selected_edges(mesh), edge_vertices(mesh)
    if not len(chosen):
        raise UsageError("Select the edges that are knit at one time, in Edit Mode")
    if edge_chains.ordered_chain(edges, chosen) is None:
        raise UsageError("Select one chain or loop of edges; these branch or fall apart")
    return chosen


def selected_vertices(mesh):
    """-> one bool per vertex"""
    chosen = np.empty(len(mesh.vertices), bool)
    mesh.vertices.foreach_get("select", chosen)
    return chosen
