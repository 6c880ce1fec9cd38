"""A mesh as the Knit Time tool sees it: arrays, read once for as long as the mesh stays the same."""

from dataclasses import dataclass, field

import bmesh
import numpy as np

from .. import compat, names, native
from ..core import edge_chains
from . import sessions
from .attributes import edge_vertices, polygon_edges, positions, read_attribute, to_world
from .constraints import constraint_marks


@dataclass
class Canvas:
    """Places are in world space. Rows are those of the object's own mesh."""

    places: np.ndarray  # (n, 3), as shown where modifiers keep the vertices
    edges: np.ndarray  # (m, 2)
    marks: np.ndarray  # (m,): 0, or 1 + the index of the edge's constraint
    rim_edges: np.ndarray  # rows of the edges that one face uses
    own: bool  # the faces that are shown are the mesh's own
    segments: np.ndarray  # (k, 2, 3): constraints as shown, on the modified mesh too
    segment_marks: np.ndarray  # (k,): the mark of each
    _made: dict = field(default_factory=dict)

    @property
    def graph(self):
        """For shortest ways. Throws NativeMissing."""
        return self._keep("graph", lambda: native.load().EdgeGraph(self.places, self.edges))

    @property
    def rims(self):
        """Boundary loops, as rows of edges."""
        return self._keep("rims", lambda: edge_chains.connected_groups(self.edges, self.rim_edges))

    @property
    def ends(self):
        """(vertex, index of the constraint) for both ends of every open chain."""
        return self._keep("ends", self._find_ends)

    def surface(self, make):
        """A BVHTree of the surface as shown, in the object's own space; `make()` makes it."""
        return self._keep("surface", make)

    def rim_of(self, edge):
        return next(rim for rim in self.rims if edge in rim)

    def chain_of(self, index):
        """-> (vertices in order, closed) of a constraint, or None if it branches or is gone."""
        rows = np.flatnonzero(self.marks == index + 1)
        return edge_chains.ordered_chain(self.edges, rows)

    def longest_edge_at(self, vertex):
        ends = self.edges[(self.edges == vertex).any(axis=1)]
        steps = self.places[ends[:, 0]] - self.places[ends[:, 1]]
        return float(np.linalg.norm(steps, axis=1).max(initial=0.0))

    def _find_ends(self):
        found = []
        for mark in np.unique(self.marks[self.marks > 0]).tolist():
            chain = self.chain_of(mark - 1)
            if chain is not None and not chain[1]:
                found += [(vertex, mark - 1) for vertex in (chain[0][0], chain[0][-1])]
        return found

    def _keep(self, name, make):
        if name not in self._made:
            self._made[name] = make()
        return self._made[name]


_held = (None, None)  # key, canvas


def canvas_of(ob, depsgraph):
    """In Object and Edit Mode. Leaves Blender's data as it is, so that drawing may call it."""
    global _held
    key = (compat.object_key(ob), sessions.mesh_revision(ob), ob.mode)
    if _held[0] != key:
        _held = (key, _read_edited(ob) if ob.mode == "EDIT" else _read(ob, depsgraph))
    return _held[1]


def forget():
    global _held
    _held = (None, None)


def _read(ob, depsgraph):
    mesh = ob.data
    edges, marks = edge_vertices(mesh), constraint_marks(mesh)
    rims = edge_chains.boundary_edges(edges, polygon_edges(mesh))
    shown = ob.evaluated_get(depsgraph).data
    own = _counts(shown) == _counts(mesh)
    places = to_world(positions(shown if own else mesh), ob.matrix_world)
    segments, segment_marks = _segments(places, edges, marks)
    if not own:
        shown_marks = read_attribute(shown, names.CONSTRAINT, "INT", "EDGE")
        if shown_marks is not None:
            at = to_world(positions(shown), ob.matrix_world)
            segments, segment_marks = _segments(at, edge_vertices(shown), shown_marks)
    return Canvas(places, edges, marks, rims, own, segments, segment_marks)


def _read_edited(ob):
    mesh = bmesh.from_edit_mesh(ob.data)
    mesh.verts.index_update()
    local = np.array([vertex.co for vertex in mesh.verts], float).reshape(-1, 3)
    pairs = [(edge.verts[0].index, edge.verts[1].index) for edge in mesh.edges]
    edges = np.array(pairs, np.int32).reshape(-1, 2)
    layer = mesh.edges.layers.int.get(names.CONSTRAINT)
    marks = [edge[layer] for edge in mesh.edges] if layer else [0] * len(edges)
    rims = np.flatnonzero([edge.is_boundary for edge in mesh.edges])
    places, marks = to_world(local, ob.matrix_world), np.array(marks, np.int32)
    own = not any(modifier.show_viewport and modifier.show_in_editmode for modifier in ob.modifiers)
    return Canvas(places, edges, marks, rims, own, *_segments(places, edges, marks))


def _counts(mesh):
    return len(mesh.vertices), len(mesh.edges), len(mesh.polygons)


def _segments(places, edges, marks):
    rows = np.flatnonzero(marks)
    return places[edges[rows]], marks[rows]
