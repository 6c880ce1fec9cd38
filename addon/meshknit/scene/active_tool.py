"""Whether the Knit Time tool is the one in use."""

from .. import names


def is_tool_active(context):
    """In the mode of the active object."""
    if context.workspace is None:
        return False
    tool = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return tool is not None and tool.idname == names.TOOL
