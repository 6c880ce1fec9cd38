"""The only code that reads or writes Blender's data."""
