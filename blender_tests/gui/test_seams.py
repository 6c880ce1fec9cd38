"""A person accepts the seams that are proposed."""

import bpy
import pytest

import meshes
from meshknit.scene import sessions
from meshknit.scene.shapes import add_object, make_mesh
from user import pump, pump_until


def codes():
    return [problem["code"] for problem in sessions.known_session(bpy.context.object).problems]


def test_the_button_below_the_proposal_allows_the_seams(user, run):
    vertices, polygons = meshes.lantern()
    add_object(bpy.context, make_mesh("Lantern", vertices * 0.001, polygons))
    for _ in range(2):
        run(bpy.ops.meshknit.add_boundary_constraint)
    with pytest.raises(RuntimeError, match="cross"):
        run(bpy.ops.meshknit.schedule)
    assert "seam-needed" in codes()
    pump(4)
    user.click(user.sidebar, *user.find_button("meshknit.allow_seams(", screens=14))
    pump_until(lambda: sessions.job() is None and "seam" in codes())
    assert bpy.context.scene.meshknit.allow_seams
    assert sessions.known_session(bpy.context.object).is_fresh("schedule")
