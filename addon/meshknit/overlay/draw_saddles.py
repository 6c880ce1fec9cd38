"""Marks the places where tubes part or meet, and says what happens there."""

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

from ..scene import sessions, shown_field
from .shown import active_object, free_room, is_within
from .text import draw_dot, draw_label

AWAY = 12  # pixels from the dot to its label

_handles = []


def _draw_labels():
    ob, shown = active_object()
    session = sessions.known_session(ob)
    field = shown_field.shown(ob)
    if session is None or field is None or not shown.show_time or ob.mode != "OBJECT":
        return
    if not session.is_guidance_fresh():
        return
    region, room = bpy.context.region, free_room()
    moved = ob.matrix_world @ field.matrix.inverted_safe()
    for saddle in session.guidance.saddles:
        place = moved @ Vector(saddle.place)
        pixel = location_3d_to_region_2d(region, bpy.context.region_data, place)
        if pixel is not None and is_within(pixel, room):
            draw_dot(*pixel)
            text = f"{saddle.time:.2f}: {saddle.text()}"
            draw_label(pixel.x + AWAY, pixel.y + AWAY, [text], room)


def register():
    if not bpy.app.background:
        view = bpy.types.SpaceView3D
        _handles.append(view.draw_handler_add(_draw_labels, (), "WINDOW", "POST_PIXEL"))


def unregister():
    for handle in _handles:
        bpy.types.SpaceView3D.draw_handler_remove(handle, "WINDOW")
    _handles.clear()
