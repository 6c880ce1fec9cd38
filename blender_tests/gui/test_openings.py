"""A person opens a closed ball by the panel's buttons."""

import bpy

from meshknit.scene import sessions
from user import pump, pump_until

KNIT = bpy.ops.meshknit


def entries():
    openings = bpy.context.object.data.meshknit.openings
    return [(round(o.time, 3), o.number) for o in openings]


def test_openings_at_the_cursor_and_from_faces_by_clicks(user, run):
    run(bpy.ops.mesh.primitive_uv_sphere_add, radius=0.05, segments=24, ring_count=12)
    run(bpy.ops.view3d.view_selected)
    bpy.context.scene.cursor.location = (0.0, 0.0, -0.05)
    user.click_button("meshknit.add_opening(")
    assert entries() == [(-1.0, 0)]
    run(bpy.ops.object.mode_set, mode="EDIT")
    run(bpy.ops.mesh.select_mode, type="FACE")
    run(bpy.ops.mesh.select_all, action="DESELECT")
    run(bpy.ops.object.mode_set, mode="OBJECT")
    ball = bpy.context.object
    for polygon in ball.data.polygons:
        polygon.select = polygon.center.z > 0.045
    run(bpy.ops.object.mode_set, mode="EDIT")
    user.click_button("meshknit.add_opening(")
    assert ball.mode == "EDIT" and entries() == [(-1.0, 0), (1.0, 1)]
    run(bpy.ops.object.mode_set, mode="OBJECT")
    user.click_button("meshknit.build_graph(")
    pump_until(lambda: sessions.job() is None and sessions.known_session(ball) is not None)
    pump(4)
    session = sessions.known_session(ball)
    assert session.is_fresh("graph"), session.message
    assert [o["time"] for o in session.report["openings"]] == [-1.0, 1.0]
    user.click(user.sidebar, *user.find_button("meshknit.remove_opening(", fraction=0.78))
    assert entries() == [(-1.0, 0)]
