"""The add-on's modules in the order in which they register."""

from . import operators, properties, tool, ui
from .overlay import draw, draw_marks, draw_saddles
from .scene import live, sessions

MODULES = (properties, sessions, live, operators, draw, draw_marks, draw_saddles, tool, ui)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
