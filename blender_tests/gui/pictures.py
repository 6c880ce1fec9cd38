"""What is seen in a picture of a 3D view, and what is shown for it."""

import bpy

from user import pump


def count(picture, kind):
    red, green, blue = picture[:, :, 0], picture[:, :, 1], picture[:, :, 2]
    if kind == "blue":
        return int(((blue > red + 0.15) & (blue > green)).sum())
    if kind == "red":
        return int(((red > blue + 0.15) & (red > green + 0.1)).sum())
    if kind == "orange":
        return int(((red > 0.9) & (green < 0.6) & (blue < 0.15)).sum())
    return int(((red > green + 0.25) & (blue > green + 0.25)).sum())  # magenta


def show(user, **shown):
    for name, value in shown.items():
        setattr(bpy.context.scene.meshknit, name, value)
    space = user.area.spaces.active
    space.show_gizmo = False
    for name in ("floor", "axis_x", "axis_y", "cursor", "outline_selected", "text"):
        setattr(space.overlay, f"show_{name}", False)
    pump(4)
