"""What the marks of the active object are."""

import bpy
import numpy as np

from meshknit.scene.attributes import read_attribute


def entries():
    """Times of the constraints, and (time, radius in mm) of the openings."""
    settings = bpy.context.object.data.meshknit
    openings = [(round(o.time, 4), round(1000.0 * o.radius, 3)) for o in settings.openings]
    return [round(c.time, 4) for c in settings.constraints], openings


def chain(index):
    """Positions of the vertices on a constraint, in the object's own space."""
    ob = bpy.context.object
    mode = ob.mode
    bpy.ops.object.mode_set(mode="OBJECT")
    marks = read_attribute(ob.data, "knit_constraint", "INT", "EDGE")
    rows = {v for e, m in zip(ob.data.edges, marks) if m == index + 1 for v in e.vertices}
    places = np.array([ob.data.vertices[v].co for v in sorted(rows)]).reshape(-1, 3)
    bpy.ops.object.mode_set(mode=mode)
    return places


def open_rims(ob):
    """Places in the world of the vertices on each open rim, the lowest rim first."""
    keys, counts = np.unique(
        [sorted(key) for face in ob.data.polygons for key in face.edge_keys],
        axis=0,
        return_counts=True,
    )
    rim_of = {}
    for a, b in keys[counts == 1]:
        joined = rim_of.get(a, {a}) | rim_of.get(b, {b})
        rim_of.update(dict.fromkeys(joined, joined))
    rims = {min(rim): sorted(rim) for rim in rim_of.values()}.values()
    places = [np.array([ob.matrix_world @ ob.data.vertices[v].co for v in rim]) for rim in rims]
    return sorted(places, key=lambda rim: rim[:, 2].mean())
