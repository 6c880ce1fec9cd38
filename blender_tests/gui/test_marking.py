"""How to mark a sock, a toy and a garment, as the documentation shows it: with `--pictures` each test
leaves its picture."""

import bpy
import numpy as np
import pytest
from mathutils import Vector

from marked import chain, entries, open_rims
from meshknit.scene import live, sessions
from user import pump, pump_until

WIDTH = 800  # of the pictures


def unmarked(user, from_last):
    """An example without its marks, the tool in hand."""
    user.fill_window()
    user.add_knit_shape(from_last)
    user.look_at_object()
    user.choose_tool("meshknit.knit_time")
    user.over_view()
    while entries() != ([], []):
        user.press("X")
    return bpy.context.object


def nearest(user, places):
    """The pixel of the place that is nearest to the viewer."""
    away = user.area.spaces.active.region_3d.view_rotation @ Vector((0.0, 0.0, 1.0))
    return user.pixel(places[np.argmax(places @ np.array(away))])


def settle(stage="graph"):
    """Lets what is built in the background be finished."""
    session = sessions.session_of(bpy.context.object)
    pump_until(lambda: session.is_guidance_fresh() and live.progress() is None)
    assert session.is_fresh(stage)


def test_a_sock(user, stills):
    """Cuff and toe are taken whole; a chain across the instep says when it is knit."""
    ob = unmarked(user, 3)
    cuff, toe = sorted(open_rims(ob), key=lambda rim: rim[:, 0].mean())
    for rim in (cuff, toe):
        user.move(user.view, *nearest(user, rim))
        user.press("C")
    assert entries() == ([-1.0, 1.0], [])
    settle()
    # From the front: across the ankle, from the instep down to the heel.
    stops = [user.pixel((0.02 - 0.045 * i / 6, 0.0, -0.09 - 0.04 * i / 6)) for i in range(7)]
    user.drag(stops)
    times, _ = entries()
    assert times[:2] == [-1.0, 1.0] and -1.0 < times[2] < 1.0
    places = chain(2)
    assert len(places) > 5 and (places[:, 1] < 0.0).all()  # on the side that one sees
    settle()
    user.move(user.view, *stops[3])
    stills.take("mark-sock", WIDTH)


def test_trousers(user, stills):
    """The waist is first, both legs are last: there the waist's tube splits."""
    ob = unmarked(user, 2)
    *legs, waist = open_rims(ob)
    user.move(user.view, *nearest(user, waist))
    user.press("C")
    user.move(user.view, *nearest(user, legs[0]))
    user.press("C")
    pump_until(lambda: sessions.session_of(ob).is_guidance_fresh())
    codes = [p["code"] for p in sessions.session_of(ob).guidance.problems]
    assert codes == ["boundary-without-time"]
    user.find_button("meshknit.give_time(")
    stills.take("guidance", WIDTH)
    user.click_button("meshknit.give_time(")
    user.over_view()
    for key in ("ONE", "RET"):
        user.press(key)
    assert entries() == ([-1.0, 1.0, 1.0], [])
    settle()
    guidance = sessions.session_of(ob).guidance
    assert [saddle.text() for saddle in guidance.saddles] == ["splits into 2"]
    stills.take("mark-trousers", WIDTH)


def test_a_toy(user, stills):
    """Round openings are dragged out: a start on one foot, and ends."""
    ob = unmarked(user, 0)
    at = np.array([ob.matrix_world @ v.co for v in ob.data.vertices])
    user.look_at_object("NUMPAD_7", ctrl=True)  # from below
    for side in (at[:, 0] < 0.0, at[:, 0] > 0.0):
        drag_opening(user, at[side][np.argmin(at[side, 2])])
        user.click()
    assert [time for time, _ in entries()[1]] == [-1.0, 1.0]
    for key in ("ONE", "MINUS", "RET"):  # the second foot begins with the first
        user.press(key)
    user.look_at_object()
    for side in (at[:, 0] < 0.0, at[:, 0] > 0.0):
        ear = at[side][np.argmax(at[side, 2])]
        drag_opening(user, ear - (0.0, 0.0, 0.012))
        stills.take("mark-toy", WIDTH)
        user.click()
        for key in ("ONE", "RET"):
            user.press(key)
        settle("time")
    _, openings = entries()
    assert [time for time, _ in openings] == [-1.0, -1.0, 1.0, 1.0]
    assert all(radius == pytest.approx(8.0, abs=2.0) for _, radius in openings)


def drag_opening(user, place):
    """An opening of about 8 mm, its radius still in hand."""
    (x, y), (right, _) = user.pixel(place), user.pixel(place + (0.008, 0.0, 0.0))
    user.move(user.view, x, y)
    user.press("R")
    for step in range(1, 5):
        user.move(user.view, x + (right - x) * step / 4, y)


def test_in_edit_mode(user, stills):
    """A ring of edges is selected with Blender's own tools, and gets its time from the menu."""
    ob = unmarked(user, 2)
    user.choose_tool("builtin.select_box")
    user.over_view()
    user.press("TAB")
    user.press("TWO")
    waist = open_rims(ob)[-1]
    # The middle of an edge, lest another edge of the vertex be meant.
    first, second = waist[np.argsort(np.abs(waist - waist[np.argmin(waist[:, 1])]).sum(axis=1))[:2]]
    user.move(user.view, *user.pixel(0.5 * (first + second)))
    user.event("LEFTMOUSE", "PRESS", alt=True)
    user.event("LEFTMOUSE", "RELEASE", alt=True)
    user.press("E", ctrl=True)
    for key in ("END", "UP_ARROW"):
        user.press(key)
    stills.take("mark-edit", WIDTH)
    user.press("RET")
    assert len(entries()[0]) == 1 and len(chain(0)) == len(waist)


def test_other_sources_of_time(user, stills):
    """The list of what times can come from."""
    user.fill_window()
    user.add_knit_shape(3)
    user.look_at_object()
    user.click(user.sidebar, *user.find_field("meshknit.time_source"))
    stills.take("sources", left=user.window.width - 560)
    user.press("D")  # the letter that is underlined in Distance
    assert bpy.context.object.data.meshknit.time_source == "DISTANCE"
    settle()
