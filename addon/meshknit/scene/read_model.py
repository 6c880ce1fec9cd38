"""An object of the scene -> the model of a run: evaluated, triangulated, in world space, in mm."""

import numpy as np

from .. import names
from ..core.model import Constraint, Model
from .attributes import edge_vertices, positions, read_attribute


def read_model(ob, depsgraph, scene, scale=None, size=None):
    """Requires Object Mode. The mesh is read as its modifiers leave it. `scale` (mm per unit) or
    `size` (mm of the longest side) are used instead of what the mesh says, if given."""
    evaluated = ob.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh(preserve_all_data_layers=True, depsgraph=depsgraph)
    try:
        local = positions(mesh)
        if scale is None:
            scale = _millimetres_per_unit(ob, local, scene, size)
        return _read(ob, mesh, local, scale)
    finally:
        evaluated.to_mesh_clear()


def _read(ob, mesh, local, scale):
    settings = getattr(ob.data, names.PROPERTIES)
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    vertices = (local @ matrix[:3, :3].T + matrix[:3, 3]) * scale
    mesh.calc_loop_triangles()
    faces = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", faces)
    faces = faces.reshape(-1, 3)
    if np.linalg.det(matrix[:3, :3]) < 0.0:
        faces = faces[:, ::-1].copy()
    polygon = np.empty(len(faces), np.int32)
    mesh.loop_triangles.foreach_get("polygon_index", polygon)
    openings = read_attribute(mesh, names.OPENING, "INT", "FACE")
    return Model(
        vertices=vertices,
        faces=faces,
        scale=scale,
        face_source=polygon,
        constraints=_read_constraints(mesh, settings),
        own_time=_read_own_time(mesh, settings),
        openings=() if openings is None else tuple(np.flatnonzero(openings).tolist()),
    )


def _read_constraints(mesh, settings):
    marks = read_attribute(mesh, names.CONSTRAINT, "INT", "EDGE")
    if marks is None:
        return ()
    pairs = edge_vertices(mesh)
    found = []
    for index, entry in enumerate(settings.constraints):
        vertices = np.unique(pairs[marks == index + 1])
        if len(vertices):
            found.append(Constraint(entry.name, tuple(vertices.tolist()), round(entry.time, 6)))
    return tuple(found)


def _read_own_time(mesh, settings):
    if settings.time_source != "ATTRIBUTE":
        return None
    times = read_attribute(mesh, names.TIME, "FLOAT", "POINT")
    return np.zeros(len(mesh.vertices)) if times is None else times.astype(np.float64)


def _millimetres_per_unit(ob, local, scene, size):
    settings = getattr(ob.data, names.PROPERTIES)
    if size is None and settings.size_mode == "SCALE":
        return settings.scale
    if size is None and settings.size_mode == "SIZE":
        size = settings.size
    if size is None:
        return 1000.0 * scene.unit_settings.scale_length
    longest = _longest_side(ob, local)
    return size / longest if longest > 0.0 else 1.0


def _longest_side(ob, local):
    """In Blender units, measured along the object's own axes as Blender's sidebar does."""
    if not np.isfinite(local).any():
        return 0.0
    extent = (np.nanmax(local, axis=0) - np.nanmin(local, axis=0)) * np.abs(
        ob.matrix_world.to_scale()
    )
    return float(np.nanmax(extent))
