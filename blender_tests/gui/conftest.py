"""One Blender for all GUI tests; every test starts with an empty scene and one 3D view."""

import bpy
import pytest

import meshknit
from user import User, pump

meshknit.register()


@pytest.fixture
def user():
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.view.smooth_view = 0
    pump(4)
    person = User()
    person.area.spaces.active.shading.show_xray = False
    pump(2)
    return person
