"""Differences between Blender 3.4 and 5.x, in one place."""

import bpy


def object_key(ob):
    """Names an object for as long as Blender runs; before 4.2 its name has to do, with that of the
    file that it is linked from."""
    return getattr(ob, "session_uid", None) or ob.name_full


def draw_progress(layout, factor, text):
    """A progress bar; a label before 4.1."""
    if hasattr(layout, "progress"):
        layout.progress(factor=factor, type="BAR", text=text)
    else:
        layout.label(text=f"{text} {factor:.0%}", icon="SORTTIME")


def set_active_color(mesh, name):
    """Makes a colour attribute the one that Solid and Vertex shading show."""
    mesh.color_attributes.active_color = mesh.color_attributes[name]


def set_polygon_sizes(mesh, sizes):
    """Since 3.6 sizes follow from where polygons start, and are read-only."""
    if not bpy.types.MeshPolygon.bl_rna.properties["loop_total"].is_readonly:
        mesh.polygons.foreach_set("loop_total", sizes)
