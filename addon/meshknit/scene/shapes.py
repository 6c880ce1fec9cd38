"""Example shapes as objects that are ready to knit."""

import bpy
import numpy as np

from .. import compat, names
from . import constraints, openings


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
    """Links an object to the collection in use, or to the scene's own where that is linked from
    another file; selects it and makes it the active one."""
    ob = bpy.data.objects.new(mesh.name, mesh)
    ob.location = location
    # The context has no selection while Blender starts, the view layer always has.
    layer = context.view_layer
    collection = layer.active_layer_collection.collection
    if collection.library is not None:
        collection = context.scene.collection
    collection.objects.link(ob)
    for other in list(layer.objects.selected):
        other.select_set(False)
    ob.select_set(True)
    layer.objects.active = ob
    return ob


def add_shape(context, name, shape, location=(0.0, 0.0, 0.0)):
    """An example shape of the library (mm) in scene units, with its marks."""
    unit = 1000.0 * context.scene.unit_settings.scale_length
    mesh = make_mesh(name, shape["vertices"] / unit, list(shape["faces"]))
    apply_marks(mesh, shape, unit)
    return add_object(context, mesh, location)


def apply_marks(mesh, shape, unit):
    """Stores an example's openings and times on its mesh, whose unit is `unit` mm."""
    rim_times = {mark["opening"]: mark["time"] for mark in shape["times"] if "opening" in mark}
    openings.store_openings(
        mesh,
        [
            (np.asarray(opening["at"]) / unit, opening["radius"] / unit, rim_times.get(index))
            for index, opening in enumerate(shape["openings"])
        ],
    )
    on_boundaries = [mark for mark in shape["times"] if "boundary_near" in mark]
    for mark, label in zip(on_boundaries, _labels([mark["time"] for mark in on_boundaries])):
        loop = constraints.boundary_near(mesh, np.asarray(mark["boundary_near"]) / unit)
        constraints.add_constraint(mesh, loop, mark["time"], label)
    getattr(mesh, names.PROPERTIES).active = 0


def _labels(times):
    """Start and End for the first and last times, Rim for those between; numbered if several."""
    kinds = [{min(times): "Start", max(times): "End"}.get(time, "Rim") for time in times]
    return [
        kind if kinds.count(kind) == 1 else f"{kind} {1 + kinds[:index].count(kind)}"
        for index, kind in enumerate(kinds)
    ]
