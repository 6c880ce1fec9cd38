"""The tool's keys, and the icons and words that name them in the status bar."""

from .. import names

STEP, FINE = 0.1, 0.01


def _press(kind, **modifiers):
    return {"type": kind, "value": "PRESS", **modifiers}


def _change(kind, sign, **modifiers):
    """A key, and the same with Shift in small steps."""
    for step, shift in ((STEP, False), (FINE, True)):
        event = _press(kind, shift=shift, **modifiers)
        yield (names.OP_CHANGE_TIME, event, {"properties": [("delta", sign * step)]})


# The key of "+" has it with Shift on some keyboards, and is then EQUAL to Blender.
KEYMAP = (
    (names.OP_DRAW_CONSTRAINT, _press("LEFTMOUSE"), None),
    (names.OP_TAKE_BOUNDARY, _press("C"), None),
    (names.OP_DRAG_OPENING, _press("R"), None),
    (names.OP_REMOVE_MARK, _press("X"), None),
    (names.OP_REMOVE_MARK, _press("DEL"), None),
    *_change("EQUAL", 1.0, repeat=True),
    *_change("PLUS", 1.0, repeat=True),
    *_change("NUMPAD_PLUS", 1.0, repeat=True),
    *_change("WHEELUPMOUSE", 1.0, ctrl=True),
    *_change("MINUS", -1.0, repeat=True),
    *_change("NUMPAD_MINUS", -1.0, repeat=True),
    *_change("WHEELDOWNMOUSE", -1.0, ctrl=True),
    *((names.OP_SET_TIME, _press(digit), None) for digit in (*names.DIGITS, "PERIOD")),
)

HELP = (
    ("MOUSE_LMB_DRAG", "Lay a Constraint"),
    ("MOUSE_LMB", "Select"),
    ("ADD", "Time: + - or Digits"),
    ("EVENT_C", "Whole Boundary"),
    ("EVENT_R", "Opening"),
    ("EVENT_X", "Delete"),
)
