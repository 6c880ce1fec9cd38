"""The model of a run: arrays in millimetres and what is marked on them."""

import hashlib
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from .time_sources import TimeSource


@dataclass(frozen=True)
class Constraint:
    """Vertices that are knit at one time."""

    name: str
    vertices: tuple  # rows of the model's vertices, or of the surface's
    time: float
    on_surface: bool = False  # rows of the checked surface, from which openings are cut


@dataclass(frozen=True)
class Opening:
    """An opening and when its rim is knit: a place with a radius, or the faces with a number."""

    name: str
    time: Optional[float] = None
    at: Optional[tuple] = None  # mm
    radius: Optional[float] = None  # mm, along the surface
    number: int = 0  # of the faces' marks


@dataclass(frozen=True)
class Model:
    """A triangle mesh (mm) with its constraints. Arrays are not changed once they are here."""

    vertices: np.ndarray  # (n, 3) float64
    faces: np.ndarray  # (m, 3) int32, anticlockwise seen from outside
    scale: float = 1.0  # mm per unit of the scene or file, for the report and for marks
    face_source: Optional[np.ndarray] = None  # triangle -> polygon of the user's mesh
    constraints: tuple = field(default_factory=tuple)
    own_time: Optional[np.ndarray] = None  # a field of the user's own, instead of constraints
    source: Optional[TimeSource] = None  # of time, instead of or beside constraints
    openings: tuple = ()  # of Opening
    face_marks: Optional[np.ndarray] = None  # (m,) int32, not 0 = left out; None: nothing marked


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
