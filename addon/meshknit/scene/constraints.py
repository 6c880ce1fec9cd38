"""Time constraints on a mesh: a list of names and times, and an edge attribute that says where.
All of this needs Object Mode."""

import numpy as np

from .. import names
from ..core import edge_chains
from .attributes import edge_vertices, polygon_edges, positions, read_attribute, write_attribute


def constraint_marks(mesh):
    """One number per edge: 0, or 1 + the index of its constraint."""
    marks = read_attribute(mesh, names.CONSTRAINT, "INT", "EDGE")
    return np.zeros(len(mesh.edges), np.int32) if marks is None else marks


def add_constraint(mesh, edges, time, name):
    """Edges that another constraint had go over to this one. -> the new constraint's index"""
    settings = getattr(mesh, names.PROPERTIES)
    index = len(settings.constraints)
    entry = settings.constraints.add()
    marks = constraint_marks(mesh)
    marks[np.asarray(edges, dtype=int)] = index + 1
    write_attribute(mesh, names.CONSTRAINT, "INT", "EDGE", marks)
    entry.name, entry.time = name, time
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


def path_through(mesh, points, closed):
    """Edges of the shortest way through the vertices nearest to points; None if there is none."""
    at = positions(mesh)
    stops = [edge_chains.nearest_vertex(at, np.asarray(point)) for point in points]
    return edge_chains.shortest_path(at, edge_vertices(mesh), stops, closed)


def selected_edges(mesh):
    chosen = np.empty(len(mesh.edges), bool)
    mesh.edges.foreach_get("select", chosen)
    return np.flatnonzero(chosen)


def selected_vertices(mesh):
    """-> one bool per vertex"""
    chosen = np.empty(len(mesh.vertices), bool)
    mesh.vertices.foreach_get("select", chosen)
    return chosen


def suggested_time(mesh):
    """For a new boundary or opening: the first is the start, the second the end, more lie between."""
    settings = getattr(mesh, names.PROPERTIES)
    times = [entry.time for entry in settings.constraints]
    times += [entry.time for entry in settings.openings if entry.has_time]
    if -1.0 not in times:
        return -1.0
    return 1.0 if 1.0 not in times else 0.0
