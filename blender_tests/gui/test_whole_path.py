"""A person's whole path with mouse and keys alone: a closed teddy, Suggest, another time for one
opening, the graph, the machine file. With `--pictures` it leaves a picture of every step."""

import bpy
import numpy as np
import pytest
from mathutils import Vector

from marked import entries
from meshknit import native
from meshknit.scene import live, sessions
from user import pump, pump_until

WIDTH = 640  # of the pictures


def session():
    return sessions.known_session(bpy.context.object)


def at_rest():
    """True when nothing is worked on, and all that is shown is of the object as it is."""
    return sessions.job() is None and live.progress() is None


def wait_for(stage, seconds=60.0):
    pump_until(lambda: at_rest() and session() and session().is_fresh(stage), seconds)


def rim_in_view(user, index):
    """A pixel on the rim of an opening: what of it is nearest to the viewer."""
    ob = bpy.context.object
    knit = session().value("check")
    rim = next(rim for rim in knit.rims if rim.opening == index)
    places = knit.cut.vertices[list(rim.vertices)] / session().results["check"].scale
    away = user.area.spaces.active.region_3d.view_rotation @ Vector((0.0, 0.0, 1.0))
    return user.pixel(places[np.argmax(places @ np.array(away))])


def test_teddy(user, stills, tmp_path, monkeypatch):
    user.fill_window()
    user.add_knit_shape(choose=False)
    stills.take("path-1", WIDTH)
    user.press("RET")
    assert bpy.context.object.name == "Teddy"
    user.look_at_object()

    # The example comes marked: take every mark away.
    user.choose_tool("meshknit.knit_time")
    user.over_view()
    while entries() != ([], []):
        user.press("X")
    pump_until(at_rest)
    user.find_button("meshknit.suggest(")
    stills.take("path-2", WIDTH)

    user.click_button("meshknit.suggest(")
    pump_until(lambda: entries() != ([], []))
    wait_for("graph")
    suggested = [time for time, _ in entries()[1]]
    assert min(suggested) == -1.0 and max(suggested) == 1.0
    stills.take("path-3", WIDTH)
    user.over_view()
    user.press("Z", ctrl=True)
    assert entries() == ([], [])
    user.press("Z", ctrl=True, shift=True)
    assert [time for time, _ in entries()[1]] == suggested
    wait_for("graph")

    # An opening that is knit neither first nor last: a little later than suggested.
    index = next(i for i, time in enumerate(suggested) if abs(time) < 0.89)
    user.click(user.view, *rim_in_view(user, index))
    user.press("NUMPAD_PLUS")
    expected = list(suggested)
    expected[index] = round(suggested[index] + 0.1, 4)
    assert [time for time, _ in entries()[1]] == pytest.approx(expected)
    stills.take("path-4", WIDTH)

    user.click_button("meshknit.build_graph(")
    wait_for("graph")
    stills.take("path-5", WIDTH)
    user.over_view()
    for key in 3 * ["NUMPAD_4"] + ["NUMPAD_8"]:
        user.press(key)
    user.scroll(60)
    user.click(user.sidebar, *user.find_field("meshknit.show_time"))
    assert not bpy.context.scene.meshknit.show_time
    stills.take("path-6", WIDTH)

    user.scroll(-60)
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "teddy.k"
    user.fill_in("meshknit.output", "teddy.k")
    assert bpy.context.scene.meshknit.output == "teddy.k"
    stills.take("path-7", WIDTH)
    user.click_button("meshknit.write_knitout(")
    pump_until(lambda: at_rest() and path.exists())
    user.scroll(60)
    user.scroll(-6)
    stills.take("path-8", WIDTH)

    # The file, read again, is what was planned; and the plan has what was marked.
    library, values = native.load(), session().results
    profile = library.machine_profile("shima_swg091n2")
    check = library.check_knitout(path.read_text(), profile, values["trace"].value)
    assert check["ok"] and check["problems"] == []
    assert path.with_suffix(".k.txt").read_text().count("\n") > 10
    report = session().report
    assert report["check"]["ok"] and session().stale_stages() == []
    times = sorted(round(opening["time"], 4) for opening in report["openings"])
    assert times == pytest.approx(sorted(expected))
