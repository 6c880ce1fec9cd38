"""What is drawn over the mesh: time colours, knit graph, legend."""

from . import draw


def register():
    draw.register()


def unregister():
    draw.unregister()
