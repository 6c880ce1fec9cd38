"""The add-on's modules in the order in which they register."""

from . import operators, properties, tool, ui
from .overlay import draw, draw_marks
from .scene import sessions

MODULES = (properties, sessions, operators, draw, draw_marks, tool, ui)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
