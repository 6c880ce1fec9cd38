"""Shows elements to the user: selects them in Edit Mode and brings them into view."""

import bmesh
import bpy
import numpy as np

from ..core.errors import UsageError
from .edit_mode import hidden_text


def select_elements(context, ob, vertices=(), edges=(), faces=()):
    """`ob` is the active object. Edges are vertex pairs. Elements that are not there are left out.
    -> how many were selected. Throws UsageError for a hidden object."""
    if not ob.visible_get():
        raise UsageError(hidden_text(ob))
    if ob.mode != "EDIT":
        bpy.ops.object.mode_set(mode="EDIT")
    only_faces = len(faces) > 0 and not len(vertices) and not len(edges)
    context.tool_settings.mesh_select_mode = (not only_faces, False, only_faces)
    mesh = bmesh.from_edit_mesh(ob.data)
    for elements in (mesh.verts, mesh.edges, mesh.faces):
        elements.ensure_lookup_table()
        for element in elements:
            element.select = False
    found = [mesh.verts[v] for v in vertices if 0 <= v < len(mesh.verts)]
    found += [mesh.faces[f] for f in faces if 0 <= f < len(mesh.faces)]
    for pair in edges:
        if max(pair) < len(mesh.verts):
            ends = [mesh.verts[v] for v in pair]
            edge = mesh.edges.get(ends)
            # The diagonal of a quad is no edge of the mesh: show its ends.
            found += [edge] if edge is not None else ends
    for element in found:
        element.select_set(True)
    bmesh.update_edit_mesh(ob.data, loop_triangles=False, destructive=False)
    _bring_into_view(context)
    return len(found)


def nearest_vertices(model_vertices, places):
    """The model vertex nearest to each place (mm)."""
    return [int(np.argmin(((model_vertices - place) ** 2).sum(axis=1))) for place in places]


def _bring_into_view(context):
    if bpy.app.background or context.area is None or context.area.type != "VIEW_3D":
        return
    region = next(r for r in context.area.regions if r.type == "WINDOW")
    with context.temp_override(region=region):
        bpy.ops.view3d.view_selected()
