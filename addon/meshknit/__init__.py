"""meshknit: knits meshes on V-bed machines. Only register() needs Blender."""

bl_info = {
    "name": "Meshknit",
    "author": "Meshknit developers",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Knit",
    "description": "Knit meshes on a knitting machine",
    "category": "Mesh",
}


def register():
    from . import registration

    registration.register()


def unregister():
    from . import registration

    registration.unregister()
