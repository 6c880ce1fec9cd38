"""What the overlays are about, and how far they lie above it."""

import bpy

from .. import names

LIFT = 0.35  # lines lie this many stitch heights nearer to the viewer than the surface


def active_object():
    """-> (active mesh object or None, the scene's properties); None where overlays are off."""
    context = bpy.context
    shown = getattr(context.scene, names.PROPERTIES)
    ob = context.object
    visible = context.space_data.overlay.show_overlays
    if ob is None or ob.type != "MESH" or not visible or not ob.visible_get():
        return None, shown
    return ob, shown


def size_of_region(kind):
    """Width and height of a region of the 3D view that is drawn; a hidden one has a pixel."""
    region = next((r for r in bpy.context.area.regions if r.type == kind), None)
    return (region.width, region.height) if region is not None else (0, 0)


def free_room():
    """Width and height of what the sidebar leaves free of the view."""
    region = bpy.context.region
    return region.width - size_of_region("UI")[0], region.height


def is_within(pixel, room):
    return 0 <= pixel[0] < room[0] and 0 <= pixel[1] < room[1]


def stitch_height(session, shown, stage):
    """In scene units, at the scale of a stage's own run."""
    result = session.results.get(stage) if session is not None else None
    return shown.stitch_height / (result.scale if result is not None else 1000.0)


def has_fresh_rims(session):
    """True if the rims of openings are known as they were cut."""
    return is_cut(session) and session.is_fresh("check")


def is_cut(session):
    return (
        session is not None
        and session.value("check") is not None
        and session.value("check").cut is not None
    )
