"""The time field of an object as it is shown."""

import numpy as np

from .. import names
from ..core.colors import time_colors
from .attributes import positions, read_attribute


def read_time_surface(ob, depsgraph):
    """-> (positions, colours, triangles) in the object's own space, as its modifiers leave it and
    without the faces that are left out, or None without a field. Where a modifier drops the field, as it is without modifiers. Requires
    Object Mode."""
    evaluated = ob.evaluated_get(depsgraph)
    surface = _read(evaluated.to_mesh())
    evaluated.to_mesh_clear()
    return surface if surface is not None else _read(ob.data)


def _read(mesh):
    times = read_attribute(mesh, names.TIME, "FLOAT", "POINT")
    if times is None or not len(times):
        return None
    mesh.calc_loop_triangles()
    triangles = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    triangles = triangles.reshape(-1, 3)
    left_out = read_attribute(mesh, names.OPENING, "INT", "FACE")
    if left_out is not None:
        polygon = np.empty(len(triangles), np.int32)
        mesh.loop_triangles.foreach_get("polygon_index", polygon)
        triangles = triangles[left_out[polygon] == 0]
    return positions(mesh), time_colors(times), triangles
