"""Text that a narrow sidebar shows whole."""

FRAME = 92  # pixels at scale 1: margins, tabs, a box and an icon
POINTS = 11  # size of Blender's own text


def wrapped(context, text):
    """The text in lines that fit the region, with an icon and in a box. Long words, such as
    paths, are broken."""
    import blf

    scale = context.preferences.system.ui_scale
    blf.size(0, POINTS * scale)
    room = max(context.region.width - FRAME * scale, 8 * POINTS * scale)
    return lines_within(text, lambda line: blf.dimensions(0, line)[0] <= room)


def lines_within(text, fits):
    """The text in lines that fit, as full as can be; what does not fit by itself is broken."""
    lines, line = [], ""
    for word in text.split():
        longer = f"{line} {word}" if line else word
        if fits(longer):
            line = longer
            continue
        if line:
            lines.append(line)
        while len(word) > 1 and not fits(word):
            count = max(1, next(n for n in range(1, len(word) + 1) if not fits(word[:n])) - 1)
            lines.append(word[:count])
            word = word[count:]
        line = word
    return lines + [line] if line else lines


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
