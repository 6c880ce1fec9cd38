"""What happens, without Blender: runs and is tested in plain Python."""
