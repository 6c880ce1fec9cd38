"""xvfb-run -a -s "-screen 0 1024x768x24" blender --factory-startup --enable-event-simulate \
-p 0 0 1024 768 --python blender_tests/run_gui.py -- [pytest arguments]

Tests are plain functions that click: pytest runs in a greenlet, which gives way to Blender's event
loop whenever a test pumps."""

import os
import sys
import traceback
from pathlib import Path

import bpy
import greenlet

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
bpy.context.preferences.view.show_splash = False
bpy.context.preferences.view.smooth_view = 0
bpy.context.preferences.system.viewport_aa = "OFF"
sys.path.insert(0, str(HERE / "gui"))

import user  # noqa: E402  (after its folder is on the path)


def run_tests():
    import pytest

    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if not any(Path(argument.split("::")[0]).exists() for argument in arguments):
        arguments.append(str(HERE / "gui"))
    return pytest.main(["-p", "no:cacheprovider", f"--rootdir={HERE}", *arguments])


tests = greenlet.greenlet(run_tests)


def tick():
    user.blender = greenlet.getcurrent()
    try:
        code = tests.switch()
    except BaseException:  # pytest itself failed: tell, and end this Blender
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(4)
    if tests.dead:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(int(code))
    return 0.0


bpy.app.timers.register(tick, first_interval=0.5, persistent=True)
