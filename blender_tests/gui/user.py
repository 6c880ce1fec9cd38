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

    def operator_under_mouse(self):
        """The Python call of the button under the mouse, as Blender itself copies it; or ''."""
        manager = bpy.context.window_manager
        manager.clipboard = ""
        with bpy.context.temp_override(window=self.window, area=self.area, region=self.sidebar):
            if bpy.ops.ui.copy_python_command_button.poll():
                bpy.ops.ui.copy_python_command_button()
        return manager.clipboard

    def find_button(self, call, fraction=0.4, screens=4):
        """Moves down the sidebar until the mouse is over the button that makes this Python call
        (its beginning is enough); then the same from the sidebar's top, scrolling. -> (x, y)"""
        x = int(self.sidebar.width * fraction)
        for screen in range(screens):
            for y in range(self.sidebar.height - 30, 5, -12):
                if not self._is_button(call, x, y):
                    continue
                # Blender may still name the button that the mouse has just left.
                for near in (y, y + 12, y + 6):
                    pump(2)
                    if self._is_button(call, x, near, turns=3):
                        return x, near
            self.scroll(-40 if screen == 0 else 8)
        raise AssertionError(f"the sidebar shows no button for {call}")

    def _is_button(self, call, x, y, turns=0):
        self.move(self.sidebar, x, y)
        pump(turns)
        return self.operator_under_mouse().startswith(f"bpy.ops.{call}")

    def scroll(self, steps):
        """Scrolls the sidebar: down for positive steps."""
        self.move(self.sidebar, self.sidebar.width // 3, self.sidebar.height // 2)
        for _ in range(abs(steps)):
            self.event("WHEELDOWNMOUSE" if steps > 0 else "WHEELUPMOUSE", "PRESS")
        pump(2)

    def click_button(self, call):
        """Clicks the button of the sidebar that makes this Python call."""
        self.click(self.sidebar, *self.find_button(call))
