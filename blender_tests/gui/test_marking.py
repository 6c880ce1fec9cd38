"""How to mark a sock, a toy and a garment, as the documentation shows it: with `--pictures` each test
leaves its picture."""

import bpy
import numpy as np
import pytest
from mathutils import Vector

from marked import entries
from meshknit.scene import live, sessions
from user import pump, pump_until

WIDTH = 900  # of the pictures


def unmarked(user, from_last):
    """An example without its marks, the tool in hand."""
    user.fill_window()
    user.add_knit_shape(from_last)
    user.choose_tool("meshknit.knit_time")
    user.over_view()
    while entries() != ([], []):
        user.press("X")
    return bpy.context.object


def open_rims(ob):
    """Places of the vertices on each open rim, from the lowest rim."""
    edges = np.array([edge.vertices for edge in ob.data.edges])
    keys = {tuple(sorted(key)) for key in ob.data.edge_keys}
    faces = [tuple(sorted(key)) for face in ob.data.polygons for key in face.edge_keys]
    counts = dict.fromkeys(keys, 0)
    for key in faces:
        counts[key] += 1
    rim_of = {}
    for a, b in (key for key, count in counts.items() if count == 1):
        joined = rim_of.get(a, {a}) | rim_of.get(b, {b})
        rim_of.update(dict.fromkeys(joined, joined))
    rims = {id(rim): rim for rim in rim_of.values()}.values()
    assert len(edges) and rims
    places = [np.array([ob.matrix_world @ ob.data.vertices[v].co for v in rim]) for rim in rims]
    return sorted(places, key=lambda rim: rim[:, 2].mean())


def nearest(user, places):
    """The pixel of the place that is nearest to the viewer."""
    away = user.area.spaces.active.region_3d.view_rotation @ Vector((0.0, 0.0, 1.0))
    return user.pixel(places[np.argmax(places @ np.array(away))])


def settle():
    ob = bpy.context.object
    pump_until(
        lambda: sessions.known_session(ob)
        and sessions.known_session(ob).is_fresh("graph")
        and live.progress() is None
    )


def test_a_sock(user, stills):
    ob = unmarked(user, 3)
    for i, key in enumerate(("NUMPAD_1", "NUMPAD_3")):
        user.look_at_object(key)
        stills.take(f"sock{i}")
    rims = open_rims(ob)
    print([r.mean(axis=0) for r in rims])
    for rim in rims[::-1]:
        user.move(user.view, *nearest(user, rim))
        user.press("C")
    print(entries())
    settle()
    stills.take("sock2")


def test_trousers(user, stills):
    ob = unmarked(user, 2)
    user.look_at_object()
    rims = open_rims(ob)
    print([r.mean(axis=0) for r in rims])
    for rim in rims[::-1]:
        user.move(user.view, *nearest(user, rim))
        user.press("C")
    print(entries())
    settle()
    stills.take("trousers")


def test_a_toy(user, stills):
    ob = unmarked(user, 0)
    user.look_at_object()
    stills.take("toy")
