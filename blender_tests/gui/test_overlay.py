"""What the overlay draws, as pixels of the screen."""

import bpy
import numpy as np

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


def test_time_is_blue_below_and_red_above(user, run, tube, picture):
    bpy.ops.meshknit.solve_time()
    show(user, show_time=False)
    plain = picture()
    show(user, show_time=True)
    shown = picture()
    assert count(shown, "blue") > count(plain, "blue") + 200
    assert count(shown, "red") > count(plain, "red") + 200
    rows = np.arange(len(shown))  # from below
    blue = (shown[:, :, 2] > shown[:, :, 0] + 0.15).sum(axis=1)
    red = (shown[:, :, 0] > shown[:, :, 2] + 0.15).sum(axis=1)
    assert (rows * blue).sum() / blue.sum() < (rows * red).sum() / red.sum()


def test_decreases_are_magenta_until_they_are_stale(user, run, picture):
    run(bpy.ops.meshknit.add_cone)
    run(bpy.ops.view3d.view_selected)
    show(user, show_time=False)
    before = count(picture(), "magenta")
    bpy.ops.meshknit.build_graph()
    pump(4)
    drawn = count(picture(), "magenta")
    assert drawn > before + 50
    bpy.context.scene.meshknit.stitch_height = 2.5
    from meshknit.scene import sessions

    sessions.look_again(bpy.context, bpy.context.object)
    pump(4)
    assert count(picture(), "magenta") < before + drawn // 4
    bpy.context.scene.meshknit.stitch_height = 1.73
    sessions.look_again(bpy.context, bpy.context.object)
    show(user, show_graph=False)
    assert count(picture(), "magenta") < before + drawn // 4


def test_an_opening_is_a_hole_in_the_colours_with_a_rim(user, run, picture):
    run(bpy.ops.mesh.primitive_uv_sphere_add, radius=0.05)
    run(bpy.ops.view3d.view_axis, type="FRONT")
    run(bpy.ops.view3d.view_selected)
    bpy.ops.meshknit.add_opening(location=(0.0, 0.0, 0.05), radius=10.0, time=-1.0)
    bpy.ops.meshknit.add_opening(location=(0.0, -0.05, 0.0), radius=25.0, time=1.0)
    show(user, show_graph=False)
    assert count(picture(), "orange") > 100  # a circle where it will be cut
    bpy.ops.meshknit.solve_time()
    pump(4)
    shown = picture()
    assert count(shown, "orange") > 100
    # In the middle of the hole, beside the dot at the object's origin.
    red, green, blue = shown[user.view.height // 2 + 15, user.view.width // 2 + 15]
    assert abs(red - green) < 0.05 and abs(green - blue) < 0.05  # the bare mesh
    assert count(shown, "red") > 200
