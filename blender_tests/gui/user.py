"""A simulated person: moves the mouse, clicks on real buttons of the sidebar, presses keys."""

import time

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

blender = None  # the greenlet of Blender's event loop


def pump(turns=1):
    """Lets Blender handle events and redraw."""
    for _ in range(turns):
        blender.switch()


def pump_until(condition, seconds=60.0):
    """Pumps until the condition holds; fails after a while."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "Blender did not get there in time"
        pump()


class User:
    def __init__(self):
        self.window = bpy.context.window_manager.windows[0]
        self.area = next(a for a in self.window.screen.areas if a.type == "VIEW_3D")
        self.view = next(r for r in self.area.regions if r.type == "WINDOW")
        self.sidebar = next(r for r in self.area.regions if r.type == "UI")
        self.place = (0, 0)

    def event(self, kind, value, **keys):
        x, y = map(int, self.place)
        self.window.event_simulate(type=kind, value=value, x=x, y=y, **keys)
        pump()

    def move(self, region, x, y):
        self.place = (region.x + x, region.y + y)
        self.event("MOUSEMOVE", "NOTHING")

    def click(self, region=None, x=0, y=0):
        if region is not None:
            self.move(region, x, y)
        self.event("LEFTMOUSE", "PRESS")
        self.event("LEFTMOUSE", "RELEASE")
        pump(2)

    def press(self, key, **keys):
        self.event(key, "PRESS", **keys)
        self.event(key, "RELEASE", **keys)
        pump(2)

    def drag(self, places, release=True):
        """Presses the left button in the 3D view, goes from place to place, and lets go."""
        self.move(self.view, *places[0])
        self.event("LEFTMOUSE", "PRESS")
        for place in places[1:]:
            self.move(self.view, *place)
        if release:
            self.event("LEFTMOUSE", "RELEASE")
            pump(2)

    def pixel(self, place):
        """Where a place of the world is in the 3D view."""
        shown = self.area.spaces.active.region_3d
        return tuple(location_3d_to_region_2d(self.view, shown, Vector(place)))

    def over_view(self):
        self.move(self.view, self.view.width // 3, self.view.height // 2)

    def open_knit_tab(self, panel):
        """Opens the sidebar and clicks its tabs from the top until `panel` is the one drawn."""
        self.area.spaces.active.show_region_ui = True
        pump(4)
        drawn = []
        draw = panel.draw
        panel.draw = lambda self_, context: (drawn.append(1), draw(self_, context))[1]
        try:
            for y in range(self.sidebar.height - 20, 20, -18):
                self.click(self.sidebar, self.sidebar.width - 8, y)
                if drawn:
                    return
        finally:
            panel.draw = draw
        raise AssertionError("the sidebar has no tab with this panel")

    def call_under_mouse(self, region=None):
        """The Python call of the button under the mouse, as Blender itself copies it; or ''."""
        return self._copied(bpy.ops.ui.copy_python_command_button, region)

    def field_under_mouse(self):
        """The data path of the sidebar's field under the mouse; or ''."""
        return self._copied(bpy.ops.ui.copy_data_path_button, full_path=True)

    def _copied(self, copy, region=None, **arguments):
        region = region or self.sidebar
        manager = bpy.context.window_manager
        manager.clipboard = ""
        with bpy.context.temp_override(window=self.window, area=self.area, region=region):
            if copy.poll():
                copy(**arguments)
        return manager.clipboard

    def find_button(self, call, fraction=0.4, screens=7):
        """Moves down the sidebar until the mouse is over the button that makes this Python call
        (its beginning is enough); then the same from the sidebar's top, scrolling. -> (x, y)"""
        beginning = f"bpy.ops.{call}"
        seen = self._find(lambda: self.call_under_mouse().startswith(beginning), fraction, screens)
        assert seen is not None, f"the sidebar shows no button for {call}"
        return seen

    def find_field(self, path, fraction=0.4, screens=4):
        """The same for a field whose data path ends like this."""
        seen = self._find(lambda: self.field_under_mouse().endswith(path), fraction, screens)
        assert seen is not None, f"the sidebar shows no field for {path}"
        return seen

    def _find(self, is_here, fraction, screens):
        x = int(self.sidebar.width * fraction)
        for screen in range(screens):
            for y in range(self.sidebar.height - 30, 5, -18):
                if not self._is_at(is_here, x, y):
                    continue
                # Blender may still name the button that the mouse has just left.
                for near in (y, y + 12, y + 6):
                    pump(2)
                    if self._is_at(is_here, x, near, turns=3):
                        return x, near
            self.scroll(-40 if screen == 0 else 8)
        return None

    def _is_at(self, is_here, x, y, turns=0):
        self.move(self.sidebar, x, y)
        pump(turns)
        return is_here()

    def scroll(self, steps):
        """Scrolls the sidebar: down for positive steps."""
        # In the margin: over a list the wheel would scroll the list.
        self.move(self.sidebar, 6, self.sidebar.height // 2)
        for _ in range(abs(steps)):
            self.event("WHEELDOWNMOUSE" if steps > 0 else "WHEELUPMOUSE", "PRESS")
        pump(2)

    def click_button(self, call):
        """Clicks the button of the sidebar that makes this Python call."""
        self.click(self.sidebar, *self.find_button(call))

    def fill_in(self, path, text):
        """Types a text into the field of the sidebar with this data path, in place of its own."""
        self.move(self.sidebar, *self.find_field(path))
        for _ in range(2):
            self.event("LEFTMOUSE", "PRESS")
            self.event("LEFTMOUSE", "RELEASE")
        self.press("A", ctrl=True)
        for character in text:
            self.event("A", "PRESS", unicode=character)
            self.event("A", "RELEASE")
        self.press("RET")

    def choose_tool(self, name):
        """Clicks a tool of the toolbar."""
        toolbar = next(r for r in self.area.regions if r.type == "TOOLS")
        for y in range(toolbar.height - 12, 5, -12):
            self.move(toolbar, toolbar.width // 2, y)
            pump(2)
            if f'"{name}"' in self.call_under_mouse(toolbar):
                self.click()
                return
        raise AssertionError(f"the toolbar has no tool {name}")

    def add_knit_shape(self, from_last=0, choose=True):
        """Add > Mesh > Knit, by keys, and there the last entry or one above it."""
        self.over_view()
        self.press("A", shift=True)
        for key in ("M", "END", "RIGHT_ARROW", "END", *["UP_ARROW"] * from_last):
            self.press(key)
        if choose:
            self.press("RET")

    def fill_window(self):
        """Gives the whole window to the 3D view."""
        self.over_view()
        self.press("SPACE", ctrl=True)
        pump(4)
        self.__init__()
        self.over_view()

    def look_at_object(self, key="NUMPAD_1", **keys):
        """From one of Blender's views, as near as it fits."""
        self.over_view()
        self.press(key, **keys)
        self.press("NUMPAD_PERIOD")
