"""Objects for tests."""

import time

import bpy
import numpy as np

from meshknit.scene import live, sessions
from meshknit.scene.attributes import read_attribute
from meshknit.scene.shapes import add_object, make_mesh


def add_mesh(vertices, polygons, name="Mesh", millimetres=True):
    """An object from arrays, in mm unless told otherwise."""
    factor = 0.001 if millimetres else 1.0
    return add_object(bpy.context, make_mesh(name, np.asarray(vertices) * factor, polygons))


def session():
    return sessions.session_of(bpy.context.object)


def knit_time(ob):
    return read_attribute(ob.data, "knit_time", "FLOAT", "POINT")


def heights(ob):
    return np.array([vertex.co.z for vertex in ob.data.vertices])


def times(ob):
    return [round(entry.time, 4) for entry in ob.data.meshknit.constraints]


def marked_edges(ob, index):
    """Vertex pairs of a constraint's edges."""
    marks = read_attribute(ob.data, "knit_constraint", "INT", "EDGE")
    return {tuple(sorted(e.vertices)) for e, m in zip(ob.data.edges, marks) if m == index + 1}


def select_only(ob, edges=(), vertices=()):
    """Selects in Edit Mode as a user would, and leaves it in Edit Mode."""
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    edges = {tuple(sorted(e)) for e in edges}
    for edge in ob.data.edges:
        edge.select = tuple(sorted(edge.vertices)) in edges
        for vertex in edge.vertices:
            if edge.select:
                ob.data.vertices[vertex].select = True
    for vertex in vertices:
        ob.data.vertices[vertex].select = True
    bpy.ops.object.mode_set(mode="EDIT")


def settle(seconds=60.0):
    """Lets the live field do all that is due, as its timer does in the GUI."""
    end = time.monotonic() + seconds
    while (wait := live.tick()) is not None:
        assert time.monotonic() < end, "the live field does not come to rest"
        time.sleep(wait)
