"""One Blender for all GUI tests; every test starts with an empty scene and the Knit tab open."""

import subprocess

import bpy
import numpy as np
import pytest

import meshknit
from meshknit.scene import sessions
from meshknit.ui.panel import MESHKNIT_PT_knit
from user import User, pump, pump_until

meshknit.register()


@pytest.fixture
def user():
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.view.smooth_view = 0
    bpy.context.preferences.system.viewport_aa = "OFF"
    pump(4)
    person = User()
    person.open_knit_tab(MESHKNIT_PT_knit)
    yield person
    if sessions.job() is not None:
        sessions.job().cancel()
        pump_until(lambda: sessions.job() is None)


@pytest.fixture
def run(user):
    """Calls an operator as if from the 3D view, for what a test takes as given."""

    def run(operator, **arguments):
        with bpy.context.temp_override(window=user.window, area=user.area, region=user.view):
            result = operator(**arguments)
        pump(4)
        return result

    return run


@pytest.fixture
def tube(run):
    """A tube that is ready to knit, active and in view."""
    run(bpy.ops.meshknit.add_straight_tube, radius=20.0, length=60.0)
    run(bpy.ops.view3d.view_selected)
    run(bpy.ops.ed.undo_push, message="tube")
    return bpy.context.object


@pytest.fixture
def picture(user):
    """Takes a picture of the 3D view as it stands on the screen: (height, width, 3), 0 to 1, from
    below. Off-screen drawing and screen.screenshot leave the overlay out in some Blenders."""

    def take():
        pump(2)
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        view = user.view
        top = user.window.height - view.y - view.height
        crop = f"{view.width - user.sidebar.width}x{view.height}+{view.x}+{top}"
        command = ["import", "-window", "root", "-crop", crop, "+repage", "-depth", "8", "ppm:-"]
        data = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
        _, width, height, _ = data.split(maxsplit=4)[:4]
        width, height = int(width), int(height)
        values = np.frombuffer(data[-width * height * 3 :], np.uint8)
        return values.reshape(height, width, 3)[::-1] / 255.0

    return take
