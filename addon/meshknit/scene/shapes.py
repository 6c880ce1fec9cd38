"""Example shapes as objects that are ready to knit."""

import bpy
import numpy as np

from .. import compat, names
from . import constraints


def make_mesh(name, vertices, polygons):
    """A mesh datablock with vertices and polygons in the given order; empty without polygons."""
    mesh = bpy.data.meshes.new(name)
    if not len(vertices) or not len(polygons):
        return mesh
    sizes = np.array([len(p) for p in polygons], np.int32)
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(vertices, np.float32).ravel())
    mesh.loops.add(int(sizes.sum()))
    mesh.loops.foreach_set("vertex_index", np.concatenate(polygons).astype(np.int32))
    mesh.polygons.add(len(polygons))
    mesh.polygons.foreach_set("loop_start", np.cumsum(sizes, dtype=np.int32) - sizes)
    compat.set_polygon_sizes(mesh, sizes)
    mesh.update(calc_edges=True)
    return mesh


def add_object(context, mesh, location=(0.0, 0.0, 0.0)):
    """Links an object to the collection in use, selects it and makes it the active one."""
    ob = bpy.data.objects.new(mesh.name, mesh)
    ob.location = location
    # The context has no selection while Blender starts, the view layer always has.
    layer = context.view_layer
    layer.active_layer_collection.collection.objects.link(ob)
    for other in list(layer.objects.selected):
        other.select_set(False)
    ob.select_set(True)
    layer.objects.active = ob
    return ob


def add_shape(context, name, shape, location=(0.0, 0.0, 0.0)):
    """An example shape of the library (mm) in scene units, with start (-1) and end (+1) marked."""
    unit = 1000.0 * context.scene.unit_settings.scale_length
    mesh = make_mesh(name, shape["vertices"] / unit, list(shape["faces"]))
    for place, time in (("start", -1.0), ("end", 1.0)):
        loop = constraints.boundary_near(mesh, np.asarray(shape[place]) / unit)
        constraints.add_constraint(mesh, loop, time, place.capitalize())
    getattr(mesh, names.PROPERTIES).active = 0
    return add_object(context, mesh, location)
