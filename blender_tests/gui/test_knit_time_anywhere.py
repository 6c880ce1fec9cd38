"""The Knit Time tool on what modelers have, and when something happens to it in mid-stroke."""

import math

import bpy
import numpy as np
import pytest
from mathutils import Vector

import meshes
import meshknit
from marked import chain, entries
from meshknit.overlay import stroke
from user import pump

TUBE = meshes.tube(40.0, 120.0, 24, 12)
LINE = [(-0.02, -0.04, 0.06), (0.0, -0.04, 0.06), (0.02, -0.04, 0.06)]


def lay(user, matrix=None, release=True):
    """A stroke across the tube's front, given in its own space."""
    matrix = matrix or bpy.context.object.matrix_world
    user.drag([user.pixel(matrix @ Vector(place)) for place in LINE], release)


def is_across_the_front(places):
    return len(places) >= 3 and (places[:, 1] < 0.0).all() and np.ptp(places[:, 2]) < 0.021


def end_stroke(user):
    user.event("LEFTMOUSE", "RELEASE")
    pump(3)
    assert stroke.shown() is None


def test_an_object_that_is_moved_turned_and_stretched_under_a_parent(user, work):
    def stretch(ob):
        parent = bpy.data.objects.new("Parent", None)
        bpy.context.collection.objects.link(parent)
        parent.location, parent.rotation_euler = (0.3, 0.1, 0.2), (0.0, 0.3, 0.0)
        parent.scale = (2.0, 1.0, 1.0)
        ob.parent = parent
        ob.rotation_euler, ob.scale = (0.0, 0.0, 0.2), (1.0, 1.5, 0.5)

    ob = work(*TUBE, prepare=stretch)
    lay(user)
    assert entries()[0] == [0.0] and is_across_the_front(chain(0))
    middle = ob.matrix_world @ Vector((0.0, -0.04, 0.09))
    user.move(user.view, *user.pixel(middle))
    user.press("R")
    user.move(user.view, *user.pixel(middle + Vector((0.01, 0.0, 0.0))))
    user.click()
    opening = ob.data.meshknit.openings[0]
    assert np.abs(np.array(opening.location) - (0.0, -0.04, 0.09)).max() < 0.004
    # 10 mm in the world, where the mean scale is the cube root of 2 x 1.5 x 0.5.
    assert opening.radius == pytest.approx(0.01 / 1.5 ** (1 / 3), rel=0.15)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_a_subdivided_tube_is_marked_at_its_own_vertices(user, work, mode):
    def subdivide(ob):
        ob.modifiers.new("Subdivision", "SUBSURF").levels = 2

    ob = work(*TUBE, mode=mode, prepare=subdivide)
    lay(user)
    assert entries()[0] == [0.0] and is_across_the_front(chain(0))
    assert len(ob.data.vertices) == 13 * 24


def test_a_deformed_tube_is_marked_where_it_is_seen(user, work):
    def raise_by_key(ob):
        ob.shape_key_add(name="Basis")
        key = ob.shape_key_add(name="Up")
        for point in key.data:
            point.co.z += 0.2
        key.value = 1.0

    work(*TUBE, prepare=raise_by_key)
    user.drag([user.pixel((x, y, z + 0.2)) for x, y, z in LINE])
    assert entries()[0] == [0.0] and is_across_the_front(chain(0))


def test_what_a_mirror_makes_cannot_be_marked_and_says_so(user, work):
    def mirror(ob):
        ob.modifiers.new("Mirror", "MIRROR")
        for vertex in ob.data.vertices:
            vertex.co.x += 0.1

    work(*TUBE, prepare=mirror)
    user.drag([user.pixel((x - 0.1, y, z)) for x, y, z in LINE])
    assert entries() == ([], [])
    user.drag([user.pixel((x + 0.1, y, z)) for x, y, z in LINE])
    assert entries()[0] == [0.0] and chain(0)[:, 0].min() > 0.05


def test_what_another_object_hides_cannot_be_marked(user, work, run):
    ob = work(*TUBE)
    run(bpy.ops.mesh.primitive_cube_add, size=0.05, location=(0.0, -0.2, 0.06))
    bpy.context.view_layer.objects.active = ob
    lay(user)
    assert entries() == ([], [])


def test_openings_of_faces_are_picked_and_removed(user, work):
    def open_front(ob):
        for polygon in ob.data.polygons:
            polygon.select = polygon.center.y < -0.03 and 0.05 < polygon.center.z < 0.09

    ob = work(*TUBE, mode="EDIT", prepare=open_front)
    bpy.ops.meshknit.add_opening(time=0.5)
    bpy.ops.meshknit.take_boundary(vertex=0, time=-1.0)
    bpy.ops.ed.undo_push(message="opening")
    user.click(user.view, *user.pixel((0.0, -0.04, 0.07)))
    user.press("NUMPAD_MINUS")
    assert entries() == ([-1.0], [(0.4, 10.0)])
    user.press("X")
    assert entries() == ([-1.0], [])
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not any(value.value for value in ob.data.attributes["knit_opening"].data)


def test_an_object_that_is_deleted_in_mid_stroke(user, work):
    ob = work(*TUBE)
    lay(user, release=False)
    bpy.data.objects.remove(ob)
    user.move(user.view, 300, 300)
    end_stroke(user)
    user.press("X")
    user.press("NUMPAD_PLUS")
    user.press("C")
    user.press("R")
    user.click(user.view, 300, 300)
    assert bpy.context.object is None


def test_a_mode_that_is_changed_in_mid_stroke(user, work):
    work(*TUBE)
    lay(user, release=False)
    bpy.ops.object.mode_set(mode="EDIT")
    user.move(user.view, 300, 300)
    end_stroke(user)
    assert entries() == ([], [])


def test_a_mesh_that_changes_in_mid_stroke_is_not_marked(user, work):
    ob = work(*TUBE)
    lay(user, release=False)
    ob.data.clear_geometry()
    bpy.context.view_layer.update()
    user.move(user.view, 300, 300)
    end_stroke(user)
    assert entries() == ([], [])


def test_a_file_that_is_loaded_in_mid_stroke(user, work, tmp_path):
    work(*TUBE)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "work.blend"))
    lay(user, release=False)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "work.blend"))
    pump(6)
    user.__init__()
    end_stroke(user)
    assert entries() == ([], [])
    lay(user)
    assert entries()[0] == [0.0]


def test_a_view_that_is_resized_in_mid_stroke(user, work):
    work(*TUBE)
    lay(user, release=False)
    user.area.spaces.active.show_region_ui = False
    user.area.spaces.active.show_region_toolbar = False
    pump(4)
    user.move(user.view, *user.pixel(LINE[0]))
    user.move(user.view, *user.pixel((-0.02, -0.04, 0.1)))
    end_stroke(user)
    assert entries()[0] == [0.0] and np.ptp(chain(0)[:, 2]) > 0.03


def test_an_area_that_becomes_another_editor_in_mid_stroke(user, work):
    work(*TUBE)
    for begin in (lambda: lay(user, release=False), lambda: user.press("ONE")):
        begin()
        user.area.type = "IMAGE_EDITOR"
        pump(3)
        user.move(user.view, 200, 200)
        user.event("LEFTMOUSE", "RELEASE")
        user.press("ESC")
        assert stroke.shown() is None
        user.area.type = "VIEW_3D"
        pump(4)
        user.__init__()
    assert entries() == ([], [])


def test_meshes_without_faces_and_no_mesh_at_all(user, work, run):
    work([], [])
    for ob in (None, bpy.data.objects.new("Empty", None)):
        if ob is not None:
            bpy.context.collection.objects.link(ob)
            bpy.context.view_layer.objects.active = ob
        user.click(user.view, 300, 300)
        for key in ("C", "R", "X", "NUMPAD_PLUS"):
            user.press(key)
            user.press("ESC")
        pump(2)


def test_the_addon_is_switched_off_while_its_tool_is_on(user, work):
    work(*TUBE)
    user.move(user.view, *user.pixel(LINE[1]))
    meshknit.unregister()
    try:
        user.move(user.view, *user.pixel(LINE[2]))
        pump(3)
    finally:
        meshknit.register()
    pump(3)


def test_the_camera_and_an_upright_view_see_the_same_surface(user, work, run):
    work(*TUBE)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.collection.objects.link(camera)
    camera.location, camera.rotation_euler = (0.0, -0.5, 0.06), (math.pi / 2, 0.0, 0.0)
    camera.data.clip_start = 0.01
    bpy.context.scene.camera = camera
    run(bpy.ops.view3d.view_camera)
    lay(user)
    assert entries()[0] == [0.0] and is_across_the_front(chain(0))
