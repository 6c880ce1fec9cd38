"""The add-on is registered once; every test starts with an empty scene."""

import bpy
import pytest

import meshknit

meshknit.register()


@pytest.fixture(autouse=True)
def empty_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.fixture
def tube():
    """A straight tube of 20 mm radius and 60 mm length, ready to knit, as the active object."""
    bpy.ops.meshknit.add_straight_tube(radius=20.0, length=60.0)
    return bpy.context.object
