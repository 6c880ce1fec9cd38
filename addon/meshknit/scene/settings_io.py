"""The scene's properties -> the settings of a run."""

from .. import names
from ..core.machines import Machine, read_machine
from ..core.settings import Settings


def read_settings(scene):
    """Throws UsageError for a machine profile file that cannot be read."""
    properties = getattr(scene, names.PROPERTIES)
    path = properties.machine_file.strip()
    machine = Machine(properties.machine)
    if path:
        import bpy

        machine = read_machine(bpy.path.abspath(path))
    # Properties are single precision: rounding gives back what was typed.
    width, height = round(properties.stitch_width, 6), round(properties.stitch_height, 6)
    return Settings(width, height, properties.relax, machine, properties.allow_seams)
