"""The active object and its mode."""

from contextlib import contextmanager

import bpy

from ..core.errors import UsageError


def active_mesh(context):
    """The active object if it is a mesh, else None. Asks the view layer: `context.object` is
    missing while Blender has no window, as when it starts or loads a file."""
    ob = context.view_layer.objects.active
    return ob if ob is not None and ob.type == "MESH" else None


def hidden_text(ob):
    """Why a hidden object cannot change its mode."""
    return f"{ob.name} is hidden: show it first"


@contextmanager
def object_mode(ob):
    """Leaves the mode of an object, and comes back to it in the end: attributes cannot be reached in
    Edit Mode. Throws UsageError where Blender does not let go of the mode: it changes that of the
    active object only, and only if one sees it."""
    mode = ob.mode
    if mode != "OBJECT":
        if bpy.context.view_layer.objects.active != ob:
            raise UsageError(f"{ob.name} is being edited: make it the active object first")
        if not ob.visible_get():
            raise UsageError(hidden_text(ob))
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)
