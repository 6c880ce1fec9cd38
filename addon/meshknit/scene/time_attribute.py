"""The solved field on the mesh: as numbers and as colours."""

import numpy as np
from mathutils.kdtree import KDTree

from .. import compat, names
from ..core.colors import time_colors, to_linear
from .attributes import positions, write_attribute


def publish_time(ob, model, times):
    """Writes the times of a model's vertices to its object. Where modifiers changed the vertices,
    each vertex of the object takes the time of the nearest one. Requires Object Mode."""
    mesh = ob.data
    values = np.asarray(times, dtype=np.float32)
    if len(values) != len(mesh.vertices):
        values = values[_nearest_rows(ob, model)]
    write_attribute(mesh, names.TIME, "FLOAT", "POINT", np.nan_to_num(values))
    write_attribute(mesh, names.TIME_COLOR, "FLOAT_COLOR", "POINT", to_linear(time_colors(values)))
    compat.set_active_color(mesh, names.TIME_COLOR)


def _nearest_rows(ob, model):
    tree = KDTree(len(model.vertices))
    for row, vertex in enumerate(model.vertices):
        tree.insert(vertex, row)
    tree.balance()
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    world = positions(ob.data) @ matrix[:3, :3].T + matrix[:3, 3]
    return np.array([tree.find(place)[1] for place in world * model.scale], dtype=int)
