"""Undo in Edit Mode."""

import bpy


def keep_lists(ob):
    """Makes the coming undo step hold the lists of constraints and openings. For operators and
    properties that change them.

    A step of Edit Mode holds the edited mesh only, and the lists would stay as they are when it is
    undone. Blender puts the whole file before such a step if data-blocks have come or gone."""
    if ob is not None and ob.mode == "EDIT":
        bpy.data.texts.remove(bpy.data.texts.new("meshknit undo"))
