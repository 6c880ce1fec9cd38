"""The active object and its mode."""

from contextlib import contextmanager

import bpy


def active_mesh(context):
    """The active object if it is a mesh, else None. Asks the view layer: `context.object` is
    missing while Blender has no window, as when it starts or loads a file."""
    ob = context.view_layer.objects.active
    return ob if ob is not None and ob.type == "MESH" else None


@contextmanager
def object_mode(ob):
    """Leaves the mode of the active object `ob`, and comes back to it in the end: attributes cannot
    be reached in Edit Mode."""
    mode = ob.mode
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)
