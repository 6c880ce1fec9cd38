"""Pictures of Blender's window for the documentation, made by tests that show what they document:
`--pictures FOLDER` says where they go; without it nothing is made."""

import subprocess
from pathlib import Path

import bpy
import pytest

from user import pump

QUALITY = "74"
# The mouse, which no picture of a virtual display shows; its point is at (0, 0).
POINTER = ((0, 0), (0, 17), (4, 13), (7, 20), (10, 19), (7, 12), (12, 12))


def pytest_addoption(parser):
    parser.addoption("--pictures", help="folder for the documentation's pictures")


class Stills:
    def __init__(self, user, folder):
        self.user, self.folder = user, folder

    def take(self, name, width=None, left=0, right=None, top=0, bottom=None):
        """The window, or a part of it in pixels from its upper left, as NAME.jpg."""
        if self.folder is None:
            return
        pump(3)
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        window = self.user.window
        right, bottom = right or window.width, bottom or window.height
        crop = f"{right - left}x{bottom - top}+{left}+{top}"
        x, y = self.user.place[0], window.height - self.user.place[1]
        corners = " ".join(f"{x + dx},{y + dy}" for dx, dy in POINTER)
        command = ["import", "-window", "root", "ppm:-"]
        shown = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
        command = ["convert", "-", "-fill", "white", "-stroke", "black"]
        command += ["-draw", f"polygon {corners}", "-crop", crop, "+repage"]
        if width is not None:
            command += ["-resize", str(width)]
        path = self.folder / f"{name}.jpg"
        command += ["-strip", "-quality", QUALITY, str(path)]
        subprocess.run(command, input=shown, check=True)


@pytest.fixture
def stills(user, request):
    folder = request.config.getoption("--pictures")
    return Stills(user, Path(folder) if folder else None)
