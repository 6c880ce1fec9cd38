"""The surface that is knit: the model without its openings, and the way back to the model."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

ON_EDGE = 1e-9  # of a face's height: rounding, not distance


@dataclass(frozen=True)
class Rim:
    """An opening as it was cut."""

    vertices: tuple  # rows of the surface, in order
    length: float  # mm
    opening: Optional[int] = None  # entry of the model's openings; None: faces that no entry names
    faces: tuple = ()  # polygons of the user's mesh, for marked faces

    def name(self, model):
        if self.opening is not None:
            return model.openings[self.opening].name
        return f"the opening of {len(self.faces)} marked faces"

    def time(self, model):
        return None if self.opening is None else model.openings[self.opening].time


@dataclass(frozen=True)
class KnitSurface:
    """The library's surface. Its rows are the model's where nothing is cut; `cut` knows the way
    back otherwise."""

    surface: object  # library.Surface
    cut: Optional[object] = None  # library.CutSurface
    rims: tuple = ()
    problems: tuple = ()
    on_edges: Optional[tuple] = None  # rows of new vertices on edges of the model, and their ends

    @property
    def ok(self):
        return not any(p["severity"] == "error" for p in self.problems)

    def arrays(self, model):
        """-> (vertices in mm, faces) of what is knit."""
        kept = model if self.cut is None else self.cut
        return kept.vertices, kept.faces

    def rows_of(self, vertices):
        """A chain of the model -> the rows of the surface on it: without what was left out, and
        with the vertices that cutting made on its edges."""
        if self.cut is None:
            return [int(v) for v in vertices]
        vertices = np.asarray(vertices, dtype=int)
        rows = self.cut.vertex_of_source[vertices]
        rows = rows[rows >= 0]
        made, ends = self.on_edges
        # Doubled vertices are one row: a seam's other side belongs to the chain, too.
        held = np.isin(ends, vertices) | np.isin(self.cut.vertex_of_source[ends], rows)
        return rows.tolist() + made[held.all(axis=1)].tolist()

    def model_rows(self, model, rows):
        """Rows of the surface -> rows of the model; a vertex on a cut is named by the nearest
        corner of its face."""
        rows = np.asarray(rows, dtype=int)
        if self.cut is None or not len(rows):
            return rows.tolist()
        sources = self.cut.source_vertex[rows]
        new = np.flatnonzero(sources < 0)
        if len(new):
            corners = model.faces[_source_faces(self.cut)[rows[new]]]
            away = model.vertices[corners] - self.cut.vertices[rows[new], None]
            nearest = (away**2).sum(axis=2).argmin(axis=1)
            sources[new] = corners[np.arange(len(new)), nearest]
        return list(dict.fromkeys(sources.tolist()))

    def for_user(self, model, problem):
        """A problem of the surface with the model's vertices and the user's polygons."""
        elements = dict(problem["elements"])
        if self.cut is not None:
            if elements.get("vertices"):
                elements["vertices"] = sorted(self.model_rows(model, elements["vertices"]))
            if elements.get("edges"):
                ends = [self.model_rows(model, list(pair)) for pair in elements["edges"]]
                elements["edges"] = [tuple(pair) for pair in ends if len(pair) == 2]
            if elements.get("faces"):
                elements["faces"] = self.cut.source_face[elements["faces"]].tolist()
        return polygons_for_user(model, {**problem, "elements": elements})

    def with_rim_names(self, model, problem):
        """A problem of boundaries whose message says which openings they are."""
        found = []
        for boundary in problem["elements"].get("boundaries", ()):
            loop = set(self.surface.boundaries[boundary]["vertices"])
            found += [r.name(model) for r in self.rims if loop == set(r.vertices)]
        if not found:
            return problem
        return {**problem, "message": f"{problem['message']} It is {' and '.join(found)}."}

    def times_for_model(self, times):
        """Times of the surface's rows -> of the model's; NaN where the surface was left out."""
        if self.cut is None:
            return times
        rows = self.cut.vertex_of_source
        return np.where(rows >= 0, np.asarray(times)[np.maximum(rows, 0)], np.nan)

    def times_of(self, model):
        """The user's own time on the surface, and on a rim with a time that time."""
        times = self.values_of(model, model.own_time)
        for rim in self.rims:
            if rim.time(model) is not None:
                times[list(rim.vertices)] = rim.time(model)
        return times

    def values_of(self, model, values):
        """Values of the model's rows -> of the surface's: on a cut between those of the face's
        corners."""
        values = np.array(values, dtype=float)
        if self.cut is None:
            return values
        sources = self.cut.source_vertex
        found = values[np.maximum(sources, 0)]
        new = np.flatnonzero(sources < 0)
        if len(new):
            corners = model.faces[_source_faces(self.cut)[new]]
            weights = _weights(model.vertices[corners], self.cut.vertices[new])
            found[new] = (weights * values[corners]).sum(axis=1)
        return found


def check_surface(library, model, stitch_width):
    """Cuts the model's openings and checks what is left."""
    marks = [i for i, opening in enumerate(model.openings) if opening.radius is not None]
    if not marks and model.face_marks is None:
        surface = library.Surface(model.vertices, model.faces, stitch_width)
        problems = tuple(polygons_for_user(model, p) for p in surface.problems)
        return KnitSurface(surface, problems=problems)
    places = [(model.openings[i].at, model.openings[i].radius) for i in marks]
    numbers = [] if model.face_marks is None else model.face_marks.tolist()
    cut = library.cut_openings(model.vertices, model.faces, numbers, places, stitch_width)
    mended = [polygons_for_user(model, p) for p in cut.problems]
    if not cut.ok:
        whole = library.Surface(model.vertices, model.faces, stitch_width)
        return KnitSurface(whole, problems=tuple(mended))
    surface = library.Surface(cut.vertices, cut.faces, stitch_width)
    by_number = {o.number: i for i, o in enumerate(model.openings) if o.radius is None}
    rims = tuple(
        Rim(
            tuple(entry["rim"]),
            entry["rim_length"],
            marks[entry["mark"]] if entry["mark"] >= 0 else by_number.get(entry["face_mark"]),
            tuple(polygons(model, entry["faces"])),
        )
        for entry in cut.openings
    )
    edges = _new_on_edges(model, cut)
    found = KnitSurface(surface, cut, rims, on_edges=edges)
    own = [found.for_user(model, found.with_rim_names(model, p)) for p in surface.problems]
    return KnitSurface(surface, cut, rims, tuple(mended + own), edges)


def polygons(model, faces):
    """Triangles of the model -> polygons of the user's mesh, ascending."""
    source = model.face_source
    return sorted({int(face if source is None else source[face]) for face in faces})


def polygons_for_user(model, problem):
    """A problem of the triangle mesh with its faces named as the user's polygons."""
    faces = problem["elements"].get("faces")
    if model.face_source is None or not faces:
        return problem
    return {**problem, "elements": {**problem["elements"], "faces": polygons(model, faces)}}


def _source_faces(cut):
    """For each row of a cut surface a face of the model that it lies in."""
    faces = np.empty(len(cut.source_vertex), dtype=int)
    faces[cut.faces] = cut.source_face[:, None]
    return faces


def _new_on_edges(model, cut):
    """The new vertices that lie on an edge of the model: (rows, (n, 2) rows of the edge's ends)."""
    new = np.flatnonzero(cut.source_vertex < 0)
    corners = model.faces[_source_faces(cut)[new]]
    weights = _weights(model.vertices[corners], cut.vertices[new])
    opposite = np.abs(weights).argmin(axis=1)
    on_edge = np.abs(weights[np.arange(len(new)), opposite]) < ON_EDGE
    ends = np.stack([(opposite + 1) % 3, (opposite + 2) % 3], axis=1)
    return new[on_edge], np.take_along_axis(corners, ends, axis=1)[on_edge]


def _weights(corners, points):
    """Of points in their triangles: (n, 3, 3) and (n, 3) -> (n, 3) that sum to 1."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    area = (normal**2).sum(axis=1)
    weight_b = (np.cross(points - a, c - a) * normal).sum(axis=1) / area
    weight_c = (np.cross(b - a, points - a) * normal).sum(axis=1) / area
    return np.column_stack([1.0 - weight_b - weight_c, weight_b, weight_c])
