"""Text that a narrow sidebar shows whole."""

import textwrap

CHARACTER = 7.5  # pixels at scale 1, of a wide one on average
FRAME = 70  # pixels at scale 1: margins, tabs, a box and an icon


def wrapped(context, text):
    """The text in lines that fit the region, with an icon and in a box. Long words, such as
    paths, are broken."""
    scale = context.preferences.system.ui_scale
    return textwrap.wrap(text, max(14, int((context.region.width / scale - FRAME) / CHARACTER)))


def draw_text(layout, context, text, icon="NONE"):
    """One label a line, the icon before the first."""
    column = layout.column(align=True)
    for line in wrapped(context, text):
        column.label(text=line, icon=icon)
        icon = "BLANK1" if icon != "NONE" else icon


def draw_value(layout, name, value):
    """A name and its value, side by side."""
    row = layout.split(factor=0.45)
    row.label(text=name)
    row.label(text=value)
