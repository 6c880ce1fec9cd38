"""The model of a run: arrays in millimetres and what is marked on them."""

import hashlib
from dataclasses import dataclass, field
from typing import Optional

import numpy as np


@dataclass(frozen=True)
class Constraint:
    """Vertices that are knit at one time."""

    name: str
    vertices: tuple  # rows of the model's vertices
    time: float


@dataclass(frozen=True)
class Model:
    """A triangle mesh (mm) with its constraints. Arrays are not changed once they are here."""

    vertices: np.ndarray  # (n, 3) float64
    faces: np.ndarray  # (m, 3) int32, anticlockwise seen from outside
    scale: float = 1.0  # mm per unit of the scene or file, for the report and for marks
    face_source: Optional[np.ndarray] = None  # triangle -> polygon of the user's mesh
    constraints: tuple = field(default_factory=tuple)
    own_time: Optional[np.ndarray] = None  # a field of the user's own, instead of constraints
    openings: tuple = ()  # polygons marked as openings


def digest(*parts):
    """A key that is equal for equal inputs only: arrays by their bytes, the rest by repr()."""
    state = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            state.update(f"{part.dtype}{part.shape}".encode())
            state.update(np.ascontiguousarray(part).tobytes())
        else:
            state.update(repr(part).encode())
        state.update(b"|")
    return state.hexdigest()


def named_for_user(model, problem):
    """A problem of the triangle mesh with its faces named as the user's polygons."""
    faces = problem["elements"].get("faces")
    if model.face_source is None or not faces:
        return problem
    polygons = sorted({int(model.face_source[face]) for face in faces})
    return {**problem, "elements": {**problem["elements"], "faces": polygons}}
