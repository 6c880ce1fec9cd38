"""Attributes cannot be reached in Edit Mode: leave it for a moment."""

from contextlib import contextmanager

import bpy


@contextmanager
def object_mode(ob):
    """Leaves the mode of the active object `ob`, and comes back to it in the end."""
    mode = ob.mode
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)
