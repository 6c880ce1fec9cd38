"""The surface that is knit: the model without its openings, and the way back to the model."""

from dataclasses import dataclass
from typing import Optional

import numpy as np


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

    @property
    def ok(self):
        return not any(p["severity"] == "error" for p in self.problems)

    def arrays(self, model):
        """-> (vertices in mm, faces) of what is knit."""
        kept = model if self.cut is None else self.cut
        return kept.vertices, kept.faces

    def rows_of(self, vertices):
        """Rows of the model -> rows of the surface, without those that were left out."""
        if self.cut is None:
            return [int(v) for v in vertices]
        rows = self.cut.vertex_of_source[np.asarray(vertices, dtype=int)]
        return rows[rows >= 0].tolist()

    def model_rows(self, model, rows):
        """Rows of the surface -> rows of the model; a vertex on a cut is named by the nearest
        corner of its face."""
        rows = np.asarray(rows, dtype=int)
        if self.cut is None or not len(rows):
            return rows.tolist()
        sources = self.cut.source_vertex[rows]
        new = np.flatnonzero(sources < 0)
        if len(new):
            corners = model.faces[self._source_faces(rows[new])]
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
        """The user's own time on the surface: on a cut between those of the face's corners, and
        on a rim with a time that time."""
        if self.cut is None:
            return model.own_time
        sources = self.cut.source_vertex
        times = np.array(model.own_time, dtype=float)[np.maximum(sources, 0)]
        new = np.flatnonzero(sources < 0)
        if len(new):
            corners = model.faces[self._source_faces(new)]
            weights = _weights(model.vertices[corners], self.cut.vertices[new])
            times[new] = (weights * model.own_time[corners]).sum(axis=1)
        for rim in self.rims:
            if rim.time(model) is not None:
                times[list(rim.vertices)] = rim.time(model)
        return times

    def _source_faces(self, rows):
        """For each row a face of the model that it lies in."""
        faces = np.empty(len(self.cut.source_vertex), dtype=int)
        faces[self.cut.faces] = self.cut.source_face[:, None]
        return faces[rows]


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
    found = KnitSurface(surface, cut, rims)
    own = [found.for_user(model, found.with_rim_names(model, p)) for p in surface.problems]
    return KnitSurface(surface, cut, rims, tuple(mended + own))


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


def _weights(corners, points):
    """Of points in their triangles: (n, 3, 3) and (n, 3) -> (n, 3) that sum to 1."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    area = (normal**2).sum(axis=1)
    weight_b = (np.cross(points - a, c - a) * normal).sum(axis=1) / area
    weight_c = (np.cross(b - a, points - a) * normal).sum(axis=1) / area
    return np.column_stack([1.0 - weight_b - weight_c, weight_b, weight_c])
