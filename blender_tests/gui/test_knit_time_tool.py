"""A person marks a surface with the Knit Time tool: a tube of 40 mm radius and 120 mm height, seen
from the front, in Object and in Edit Mode."""

import subprocess

import bpy
import numpy as np
import pytest

import meshes
from meshknit.overlay import stroke
from meshknit.scene.attributes import read_attribute
from meshknit.tool import hover
from marked import chain, entries
from user import pump

KNIT = bpy.ops.meshknit
FRONT = -0.04  # y of the tube's front
MODES = pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])


@pytest.fixture
def tube(work):
    return lambda mode="OBJECT": work(*meshes.tube(40.0, 120.0, 24, 12), mode)


def along(user, *places):
    """Pixels of places on the front of the tube, given as (x, z) in mm, with stops between."""
    points = [np.array((x / 1000, FRONT, z / 1000)) for x, z in places]
    stops = [points[0]]
    for a, b in zip(points, points[1:]):
        stops += [a + (b - a) * i / 4 for i in range(1, 5)]
    return [user.pixel(stop) for stop in stops]


def point_at(user, x, z):
    user.move(user.view, *along(user, (x, z))[0])


def undo(user):
    user.press("Z", ctrl=True)


def redo(user):
    user.press("Z", ctrl=True, shift=True)


@MODES
def test_a_stroke_lays_a_chain_and_is_one_step(user, tube, mode):
    tube(mode)
    user.drag(along(user, (-20, 60), (20, 60)))
    assert entries() == ([0.0], []) and bpy.context.object.mode == mode
    places = chain(0)
    # 24 vertices round: the front 40 mm hold 4 or 5 of them, all on the side that one sees.
    assert 3 <= len(places) <= 6 and (places[:, 1] < 0.0).all()
    assert np.abs(places[:, 2] - 0.06).max() < 0.011
    undo(user)
    assert entries() == ([], []) and bpy.context.object.mode == mode
    redo(user)
    assert entries() == ([0.0], []) and len(chain(0)) == len(places)


@MODES
def test_keys_and_the_wheel_change_the_time(user, tube, mode):
    tube(mode)
    user.drag(along(user, (-20, 60), (20, 60)))
    seen = []
    for key, keys in (
        ("EQUAL", {}),
        ("NUMPAD_PLUS", {}),
        ("MINUS", {}),
        ("EQUAL", {"shift": True}),
        ("NUMPAD_MINUS", {"shift": True}),
        ("NUMPAD_MINUS", {}),
    ):
        user.press(key, **keys)
        seen.append(entries()[0][0])
    assert seen == [0.1, 0.2, 0.1, 0.11, 0.1, 0.0]
    user.event("WHEELUPMOUSE", "PRESS", ctrl=True)
    user.event("WHEELDOWNMOUSE", "PRESS", ctrl=True, shift=True)
    pump(2)
    assert entries()[0] == [0.09]
    for key in ("ZERO", "PERIOD", "TWO", "FIVE", "MINUS", "RET"):
        user.press(key)
    assert entries()[0] == [-0.25]
    user.press("ONE")
    user.press("ESC")
    assert entries()[0] == [-0.25]
    undo(user)
    undo(user)
    assert entries()[0] == [0.1] and bpy.context.object.mode == mode
    redo(user)
    assert entries()[0] == [0.09]


@MODES
def test_a_click_selects_and_x_deletes(user, tube, mode):
    tube(mode)
    user.drag(along(user, (-20, 40), (20, 40)))
    user.drag(along(user, (-20, 80), (20, 80)))
    user.click(user.view, *along(user, (0, 40))[0])
    user.press("NUMPAD_PLUS")
    assert entries()[0] == [0.1, 0.0]
    user.press("X")
    assert entries()[0] == [0.0] and len(bpy.context.object.data.vertices) == 13 * 24
    assert chain(0)[:, 2].mean() == pytest.approx(0.08, abs=0.006)
    user.press("X")
    user.press("X")  # nothing is left: the mesh must not go
    assert entries() == ([], []) and bpy.context.object.name == "Work"
    for left in ([0.0], [0.1, 0.0], [0.0, 0.0]):
        undo(user)
        assert entries()[0] == left


def test_a_click_on_the_bare_surface_changes_nothing(user, tube):
    tube()
    user.click(user.view, *along(user, (0, 60))[0])
    user.click(user.view, *along(user, (200, 60))[0])
    assert entries() == ([], [])


@MODES
def test_c_takes_a_whole_boundary(user, tube, mode):
    tube(mode)
    for z in (0.0, 120.0):
        point_at(user, 5.0, z)
        user.press("C")
    assert entries()[0] == [-1.0, 1.0]
    assert len(chain(0)) == len(chain(1)) == 24
    assert (chain(0)[:, 2] == 0.0).all() and chain(1)[:, 2].min() > 0.119
    user.press("C")  # a second time selects it
    point_at(user, 5.0, 60.0)
    user.press("C")  # no boundary here
    assert entries()[0] == [-1.0, 1.0]
    undo(user)
    undo(user)
    undo(user)
    assert entries()[0] == []


@MODES
def test_r_drags_an_opening(user, tube, mode):
    tube(mode)
    point_at(user, 0.0, 60.0)
    user.press("R")
    for place in along(user, (0, 60), (0, 75)):
        user.move(user.view, *place)
    user.click()
    ((time, radius),) = entries()[1]
    assert time == -1.0 and radius == pytest.approx(15.0, abs=1.0)
    place = np.array(bpy.context.object.data.meshknit.openings[0].location)
    assert np.abs(place - (0.0, FRONT, 0.06)).max() < 0.002
    undo(user)
    assert entries() == ([], []) and bpy.context.object.mode == mode
    redo(user)
    user.press("NUMPAD_PLUS")
    assert entries()[1][0][0] == -0.9
    user.press("X")
    assert entries() == ([], [])


@MODES
def test_escape_and_the_right_button_leave_nothing(user, tube, mode):
    ob = tube(mode)
    for leave in ("ESC", "RIGHTMOUSE"):
        user.drag(along(user, (-20, 60), (20, 60)), release=False)
        assert stroke.shown() is not None
        user.press(leave)
        user.event("LEFTMOUSE", "RELEASE")
        assert stroke.shown() is None and entries() == ([], [])
        point_at(user, 0.0, 60.0)
        user.press("R")
        point_at(user, 10.0, 60.0)
        assert stroke.shown() is not None
        user.press(leave)
        assert stroke.shown() is None and entries() == ([], [])
    bpy.ops.object.mode_set(mode="OBJECT")
    assert "knit_constraint" not in ob.data.attributes


def test_back_over_the_chain_shortens_it(user, tube):
    tube()
    user.drag(along(user, (0, 30), (0, 90), (0, 60)))
    places = chain(0)
    assert 0.02 < places[:, 2].min() < 0.04 and 0.05 < places[:, 2].max() < 0.07


def test_a_drag_from_its_end_goes_on_with_a_chain(user, tube):
    tube()
    user.drag(along(user, (0, 30), (0, 60)))
    user.press("NUMPAD_PLUS")
    user.drag(along(user, (0, 60), (0, 90)))
    assert entries()[0] == [0.1] and chain(0)[:, 2].max() == pytest.approx(0.09, abs=1e-4)
    assert chain(0)[:, 2].min() == pytest.approx(0.03, abs=1e-4)
    undo(user)
    assert entries()[0] == [0.1] and chain(0)[:, 2].max() == pytest.approx(0.06, abs=1e-4)


def test_a_drag_round_closes_a_loop(user, work):
    # A cloth of 10 x 10 squares from above; a ring of 6 x 6 sides round its middle.
    side = 11
    vertices = [(c * 10.0, r * 10.0, 0.0) for r in range(side) for c in range(side)]
    corners = [(r * side + c, r * side + c + 1) for r in range(10) for c in range(10)]
    ob = work(vertices, [[a, b, b + side, a + side] for a, b in corners], view="TOP")
    points = [(20, 20), (80, 20), (80, 80), (20, 80), (20, 20)]
    stops = [np.array(points[0], float)]
    for a, b in zip(points, points[1:]):
        stops += [np.array(a) + (np.array(b) - a) * i / 6 for i in range(1, 7)]
    user.drag([user.pixel((x / 1000, y / 1000, 0.0)) for x, y in stops])
    marks = read_attribute(ob.data, "knit_constraint", "INT", "EDGE")
    ends = np.array([e.vertices for e in ob.data.edges])[marks == 1]
    _, degrees = np.unique(ends, return_counts=True)
    assert len(ends) == 24 and (degrees == 2).all()


def test_the_view_turns_and_zooms_while_a_chain_is_laid(user, tube):
    tube()
    shown = user.area.spaces.active.region_3d
    user.drag(along(user, (-20, 60), (0, 60)), release=False)
    before, away = shown.view_matrix.copy(), shown.view_distance
    user.event("WHEELUPMOUSE", "PRESS")
    pump(3)
    assert shown.view_distance < away
    user.event("MIDDLEMOUSE", "PRESS")
    x, y = user.place[0] - user.view.x, user.place[1] - user.view.y
    for step in (10, 20, 30):
        user.move(user.view, x + step, y)
    user.event("MIDDLEMOUSE", "RELEASE")
    assert shown.view_matrix != before
    user.event("LEFTMOUSE", "RELEASE")
    pump(2)
    assert entries()[0] == [0.0]


def test_the_time_of_new_marks_is_set_in_the_header(user, tube):
    tube()
    scene = bpy.context.scene.meshknit
    scene.new_time_from, scene.new_time = "VALUE", 0.35
    user.drag(along(user, (-20, 60), (20, 60)))
    assert entries()[0] == [0.35]


def test_a_new_chain_has_the_time_of_its_place(user, tube):
    tube()
    for vertex, time in ((0, -1.0), (12 * 24, 1.0)):
        KNIT.take_boundary(vertex=vertex, time=time)
    KNIT.solve_time()
    # Half as high again as the middle: time 0.5; 5 mm off is 0.083.
    user.drag(along(user, (-20, 90), (20, 90)))
    assert entries()[0][2] == pytest.approx(0.5, abs=0.05)


def test_saved_and_loaded_again_the_tool_goes_on(user, tube, tmp_path):
    tube()
    user.drag(along(user, (-20, 60), (20, 60)))
    count = len(chain(0))
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "work.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "work.blend"))
    pump(6)
    user.__init__()
    assert entries()[0] == [0.0] and len(chain(0)) == count
    user.click(user.view, *along(user, (0, 60))[0])
    user.press("NUMPAD_PLUS")
    user.drag(along(user, (-20, 90), (20, 90)))
    assert entries()[0] == [0.1, 0.0]


@MODES
def test_a_chain_is_seen_while_it_is_drawn_and_after(user, tube, picture, mode):
    tube(mode)
    before = picture()
    user.drag(along(user, (-25, 60), (25, 60)), release=False)
    during = picture()
    user.event("LEFTMOUSE", "RELEASE")
    user.move(user.view, 5, 5)
    pump(3)
    after = picture()
    # A band of 10 mm round the stroke.
    (left, low), (right, high) = along(user, (-25, 55))[0], along(user, (25, 65))[0]
    box = (slice(int(low), int(high)), slice(int(left), int(right)))

    def pale(shown):
        """Of the stroke: pale yellow is the colour of time 0, white that of what is selected."""
        return (shown[box][:, :, :2] > 0.85).all(axis=2).sum()

    width = int(right - left)  # the line is thicker than a pixel
    assert pale(before) < width / 4
    assert pale(during) > pale(before) + width and pale(after) > pale(before) + width
    undo(user)
    pump(3)
    assert pale(picture()) < width / 4


def test_what_lies_under_the_mouse_is_told(user, tube, monkeypatch):
    tube()
    told = []
    describe = hover.describe
    monkeypatch.setattr(hover, "describe", lambda *a: told.append(describe(*a)) or told[-1])
    KNIT.take_boundary(vertex=0, time=-1.0)
    KNIT.take_boundary(vertex=12 * 24, time=1.0)
    KNIT.solve_time()
    user.drag(along(user, (-20, 60), (20, 60)))

    def at(x, z):
        point_at(user, x + 2.0, z)
        point_at(user, x, z)
        pump(3)
        return told[-1]

    assert at(0.0, 90.0)[-1] == "Drag: lay a constraint"
    assert float(at(0.0, 90.0)[0].split()[1]) == pytest.approx(0.5, abs=0.1)
    assert at(0.0, 60.0)[1:] == ["Constraint 3: 0", "Click: select"]
    assert "Click: select" in at(5.0, 0.0) and "C: whole boundary" in at(5.0, 0.0)
    assert at(-60.0, 60.0) == []  # beside the tube


def test_the_vertex_where_a_chain_would_begin_has_a_dot(user, tube, picture):
    tube()
    ((x, y),) = along(user, (0, 60))
    box = (slice(int(y) - 8, int(y) + 8), slice(int(x) - 8, int(x) + 8))

    def white():
        return (picture()[box] > 0.9).all(axis=2).sum()

    user.move(user.view, 20, 20)
    pump(3)
    assert white() < 10
    user.move(user.view, x + 1, y)
    user.move(user.view, x, y)
    pump(3)
    assert white() > 30  # a disk of more than 3 pixels' radius


def test_the_status_bar_has_the_keys_while_the_tool_is_on(user, tube, run):
    def bar():
        """How many pixels of the status bar, the lowest line of the window, are text."""
        pump(4)
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        place = f"{user.window.width // 2}x18+0+{user.window.height - 20}"
        command = ["import", "-window", "root", "-crop", place, "-depth", "8", "gray:-"]
        shown = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
        return (np.frombuffer(shown, np.uint8) > 120).sum()

    tube()
    texts = {}
    for tool in ("builtin.select_box", "meshknit.knit_time") * 2:
        run(bpy.ops.wm.tool_set_by_id, name=tool)
        for x in (0.0, 5.0):
            point_at(user, x, 60.0)
        texts.setdefault(tool, []).append(bar())
    assert min(texts["meshknit.knit_time"]) > 2 * max(texts["builtin.select_box"])
