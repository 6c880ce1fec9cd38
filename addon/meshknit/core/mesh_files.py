"""Readers of .obj, .ply and .stl that keep vertices and polygons as the file has them.

Blender's own importers differ between versions in axes, vertex order and what they merge; marks
files and reports name places of the file, so the file is read as it is."""

from pathlib import Path

import numpy as np

from .errors import UsageError
from .ply_file import read_ply

SUFFIXES = (".obj", ".ply", ".stl")
OTHER_OBJ_WORDS = {"vt", "vn", "vp", "o", "g", "s", "l", "p", "mtllib", "usemtl"}


def read_mesh_file(path):
    """-> ((n, 3) float64 vertices, list of polygons as vertex lists), both empty for an empty mesh.
    Throws UsageError."""
    path = Path(path)
    readers = {".obj": _read_obj, ".ply": read_ply, ".stl": _read_stl}
    if path.suffix.lower() not in readers:
        raise UsageError(f"{path} is not one of {', '.join(SUFFIXES)}")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from error
    try:
        vertices, polygons = readers[path.suffix.lower()](data)
    except (ValueError, IndexError, KeyError, OverflowError) as error:
        raise UsageError(f"{path} is not a readable {path.suffix[1:]} file: {error}") from error
    vertices = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    _require_known_vertices(path, polygons, len(vertices))
    return vertices, polygons


def _require_known_vertices(path, polygons, count):
    for index, polygon in enumerate(polygons):
        if len(polygon) < 3:
            raise UsageError(f"{path}: face {index} has fewer than three corners")
        strange = [vertex for vertex in polygon if not 0 <= vertex < count]
        if strange:
            raise UsageError(
                f"{path}: face {index} has a corner at vertex {strange[0]}, but the file has "
                f"{count} vertices (all counted from 0)"
            )


def _read_obj(data):
    vertices, polygons, strange = [], [], None
    for number, line in enumerate(data.decode("utf-8", "replace").splitlines(), 1):
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        if words[0] == "v":
            if len(words) < 4:
                raise ValueError(f"line {number}: a vertex has three coordinates")
            vertices.append([float(word) for word in words[1:4]])
        elif words[0] == "f":
            indices = [int(word.split("/")[0]) for word in words[1:]]
            if 0 in indices:
                raise ValueError(f"line {number}: vertices count from 1")
            polygons.append([i - 1 if i > 0 else len(vertices) + i for i in indices])
        elif words[0] not in OTHER_OBJ_WORDS:
            strange = strange or number
    if strange and not vertices:
        raise ValueError(f"line {strange} is not Wavefront OBJ")
    return vertices, polygons


def _read_stl(data):
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        corner = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
        corners = np.frombuffer(data, corner, count, 84)["corners"].reshape(-1, 3)
    elif data.lstrip()[:5] == b"solid":
        words = data.decode("utf-8", "replace").split()
        at = [i for i, word in enumerate(words) if word == "vertex"]
        corners = np.array([[float(x) for x in words[i + 1 : i + 4]] for i in at]).reshape(-1, 3)
    else:
        raise ValueError("it is neither binary nor text STL, or cut short")
    if len(corners) % 3:
        raise ValueError("a triangle is cut short")
    return _weld(corners)


def _weld(corners):
    """STL repeats a vertex in every triangle: equal positions become one, as they appear."""
    if not len(corners):
        return corners, []
    _, first, inverse = np.unique(corners, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    return corners[first[order]], place[inverse.ravel()].reshape(-1, 3).tolist()
