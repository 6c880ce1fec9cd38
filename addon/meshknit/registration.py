"""The add-on's modules in the order in which they register."""

from . import operators, properties, ui
from .overlay import draw
from .scene import sessions

MODULES = (properties, sessions, operators, draw, ui)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
