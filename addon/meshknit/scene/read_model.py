"""An object of the scene -> the model of a run: evaluated, triangulated, in world space, in mm."""

import numpy as np

from .. import names
from ..core.errors import UsageError
from ..core.model import AT_DIGITS, RADIUS_DIGITS, Constraint, Model, Opening
from ..core.time_sources import TimeSource
from .attributes import edge_vertices, positions, read_attribute


def read_model(ob, depsgraph, scene, scale=None, size=None):
    """Requires Object Mode. The mesh is read as its modifiers leave it. `scale` (mm per unit) or
    `size` (mm of the longest side) are used instead of what the mesh says, if given. Throws
    UsageError."""
    evaluated = ob.evaluated_get(depsgraph)
    if not evaluated.is_evaluated:
        raise UsageError(
            f"{ob.name}, or a collection that it is in, is disabled in the viewport: Blender leaves "
            "out its modifiers and its place then. Enable it in the outliner"
        )
    mesh = evaluated.to_mesh(preserve_all_data_layers=True, depsgraph=depsgraph)
    try:
        local = positions(mesh)
        _require_no_instances(ob, mesh, depsgraph)
        if scale is None:
            scale = millimetres_per_unit(ob, local, scene, size)
        return _read(ob, mesh, local, scale)
    finally:
        evaluated.to_mesh_clear()


def _require_no_instances(ob, mesh, depsgraph):
    """Instances are no part of the mesh that is read: an object of nothing else says so."""
    if len(mesh.polygons):
        return
    for shown in depsgraph.object_instances:
        if shown.is_instance and shown.parent is not None and shown.parent.original == ob:
            raise UsageError(
                f"{ob.name} shows instances, which are no mesh of its own: add a Realize Instances "
                "node, or make them real (Object > Apply)"
            )


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
    numbers = read_attribute(mesh, names.OPENING, "INT", "FACE")
    return Model(
        vertices=vertices,
        faces=faces,
        scale=scale,
        face_source=polygon,
        constraints=_read_constraints(mesh, settings),
        own_time=_read_own_time(mesh, settings),
        source=_read_source(ob, mesh, settings),
        openings=_read_openings(settings, matrix, scale),
        face_marks=numbers[polygon] if numbers is not None and numbers.any() else None,
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
            time = round(entry.time, 6)
            found.append(Constraint(entry.name, tuple(vertices.tolist()), time, entry=index))
    return tuple(found)


def _read_openings(settings, matrix, scale):
    """In millimetres. Where the object is scaled unevenly, a radius grows by the mean."""
    mean = mean_scale(matrix)
    found = []
    for entry in settings.openings:
        time = round(entry.time, 6) if entry.has_time else None
        if entry.number:
            found.append(Opening(entry.name, time, number=entry.number))
            continue
        at = (matrix[:3, :3] @ np.array(entry.location) + matrix[:3, 3]) * scale
        # Properties are single precision: rounding gives back what was typed or suggested.
        at = tuple(np.round(at, AT_DIGITS).tolist())
        radius = round(entry.radius * mean * scale, RADIUS_DIGITS)
        found.append(Opening(entry.name, time, at, radius))
    return tuple(found)


def mean_scale(matrix):
    """How much longer an object's transform makes things, as the mean of its axes."""
    return float(abs(np.linalg.det(np.asarray(matrix)[:3, :3])) ** (1.0 / 3.0))


def _read_own_time(mesh, settings):
    if settings.time_source != "ATTRIBUTE":
        return None
    times = read_attribute(mesh, names.TIME, "FLOAT", "POINT")
    return np.zeros(len(mesh.vertices)) if times is None else times.astype(np.float64)


def _read_source(ob, mesh, settings):
    """Throws UsageError if the values are not there."""
    if settings.time_source in ("CONSTRAINTS", "ATTRIBUTE"):
        return None
    share = round(settings.time_share, 6)
    if settings.time_source != "VALUES":
        kind, axis = settings.time_source, settings.time_axis
        return TimeSource(kind, axis, share=share, mend=settings.time_mend)
    values = _named_values(ob, mesh, settings.time_values)
    return TimeSource("VALUES", values=values, share=share, mend=settings.time_mend)


def _named_values(ob, mesh, name):
    """Of a point attribute, or the weights of a vertex group: one a vertex."""
    if name == names.TIME:
        raise UsageError(f"for the attribute {names.TIME} choose it as the source of time")
    for kind in ("FLOAT", "INT"):
        values = read_attribute(mesh, name, kind, "POINT")
        if values is not None:
            return values.astype(np.float64)
    group = ob.vertex_groups.get(name)
    if group is None:
        wanted = f"no point attribute and no vertex group {name}" if name else "no name for it"
        raise UsageError(f"time comes from an attribute or a vertex group, but there is {wanted}")
    values = np.zeros(len(mesh.vertices))
    for vertex in mesh.vertices:
        for entry in vertex.groups:
            if entry.group == group.index:
                values[vertex.index] = entry.weight
    return values


def millimetres_per_unit(ob, local, scene, size=None):
    """`local`: the vertices in the object's own space."""
    settings = getattr(ob.data, names.PROPERTIES)
    if size is None and settings.size_mode == "SCALE":
        return settings.scale
    if size is None and settings.size_mode == "SIZE":
        size = settings.size
    if size is None:
        return 1000.0 * scene.unit_settings.scale_length
    longest = _longest_side(ob, local)
    return size / longest if longest > 0.0 else 1.0


def millimetres_of_radius(scene, ob):
    """Millimetres that a unit of a round opening's radius becomes: such lengths are of the object's
    own space, so that openings grow with it. Requires Object Mode."""
    longer = mean_scale(ob.matrix_world)
    return millimetres_per_unit(ob, positions(ob.data), scene) * (longer if longer > 0.0 else 1.0)


def _longest_side(ob, local):
    """In Blender units, measured along the object's own axes as Blender's sidebar does."""
    if not np.isfinite(local).any():
        return 0.0
    extent = (np.nanmax(local, axis=0) - np.nanmin(local, axis=0)) * np.abs(
        ob.matrix_world.to_scale()
    )
    return float(np.nanmax(extent))
