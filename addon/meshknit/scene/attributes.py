"""Attributes of a mesh as arrays. All of this needs Object Mode (see edit_mode.py)."""

import numpy as np

FIELDS = {
    "FLOAT": ("value", np.float32, 1),
    "INT": ("value", np.int32, 1),
    "FLOAT_COLOR": ("color", np.float32, 4),
}


def read_attribute(mesh, name, kind, domain):
    """The values as an array, or None if there is no attribute of this name, kind and domain."""
    attribute = mesh.attributes.get(name)
    if attribute is None or (attribute.data_type, attribute.domain) != (kind, domain):
        return None
    member, number, width = FIELDS[kind]
    values = np.empty(len(attribute.data) * width, number)
    attribute.data.foreach_get(member, values)
    return values.reshape(-1, width) if width > 1 else values


def write_attribute(mesh, name, kind, domain, values):
    """Makes the attribute if needed. One of the same name but another kind is replaced."""
    attribute = mesh.attributes.get(name)
    if attribute is not None and (attribute.data_type, attribute.domain) != (kind, domain):
        mesh.attributes.remove(attribute)
        attribute = None
    if attribute is None:
        mesh.attributes.new(name, kind, domain)
    member, number, _ = FIELDS[kind]
    # Found again by name: a reference from before new() may point to freed memory.
    data = mesh.attributes[name].data
    data.foreach_set(member, np.ascontiguousarray(values, dtype=number).ravel())
    mesh.update()


def edge_vertices(mesh):
    """(n, 2) vertex pairs."""
    pairs = np.empty(2 * len(mesh.edges), np.int32)
    mesh.edges.foreach_get("vertices", pairs)
    return pairs.reshape(-1, 2)


def polygon_edges(mesh):
    """One edge per polygon corner."""
    edges = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("edge_index", edges)
    return edges


def positions(mesh):
    """(n, 3) float64, in the object's own space."""
    values = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", values)
    return values.reshape(-1, 3).astype(np.float64)


def to_world(points, matrix):
    """(n, 3) points of an object's own space -> world space."""
    matrix = np.array(matrix, dtype=np.float64)
    return points @ matrix[:3, :3].T + matrix[:3, 3]
