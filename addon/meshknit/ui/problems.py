"""A list of problems: what, what to change, and buttons for it."""

from .text import draw_text

ICONS = {"error": "CANCEL", "warning": "ERROR", "note": "INFO"}
MOST = 12


def draw_problems(layout, context, problems, draw_buttons):
    """A box for each of the first ones; draw_buttons(layout, index, problem) adds what a click can
    do about it."""
    for index, problem in enumerate(problems[:MOST]):
        box = layout.box()
        draw_text(box, context, problem["message"], ICONS[problem["severity"]])
        draw_text(box, context, problem["remedy"], "BLANK1")
        # One below the other: side by side, a narrow sidebar cuts their words off.
        draw_buttons(box.column(align=True), index, problem)
    left = len(problems) - MOST
    if left > 0:
        layout.label(text=f"and {left} more")
