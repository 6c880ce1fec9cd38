"""Type a time."""

import bpy

from .. import names
from ..core.typed_number import TypedNumber
from ..scene import mark_lists
from ..scene.edit_mode import active_mesh
from .edit_mark import KeyOperator, selected
from .mark_base import time_property

CHARACTERS = {
    **{name: str(digit) for digit, name in enumerate(names.DIGITS)},
    **{f"NUMPAD_{digit}": str(digit) for digit in range(10)},
    **dict.fromkeys(("PERIOD", "NUMPAD_PERIOD", "COMMA"), "."),
    **dict.fromkeys(("MINUS", "NUMPAD_MINUS"), "-"),
    "BACK_SPACE": "\b",
}


class MESHKNIT_OT_set_time(KeyOperator, bpy.types.Operator):
    """Give the selected constraint or opening a time, by typing the number"""

    bl_idname = names.OP_SET_TIME
    bl_label = "Set Knit Time"

    time: time_property("it is")

    def change(self, context, ob):
        marks, index = selected(ob.data)
        mark_lists.set_time(ob.data, marks, index, self.time)

    def invoke(self, context, event):
        mesh = active_mesh(context).data
        found = mark_lists.selected_mark(mesh)
        if found is None or context.area is None:
            return super().invoke(context, event)
        self._name = found[0].entries(mesh)[found[1]].name
        self._typed = TypedNumber()
        self._take(context, event)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        gone = active_mesh(context) is None or context.area is None
        if gone or (event.type in {"ESC", "RIGHTMOUSE"} and event.value == "PRESS"):
            self._end(context)
            return {"CANCELLED"}
        if event.type in {"RET", "NUMPAD_ENTER", "LEFTMOUSE"} and event.value == "PRESS":
            self._end(context)
            value = self._typed.value
            if value is None:
                return {"CANCELLED"}
            self.time = min(1.0, max(-1.0, value))
            return self.execute(context)
        if event.value == "PRESS":
            self._take(context, event)
        moving = event.type in {"MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "TIMER", "MIDDLEMOUSE"}
        return {"PASS_THROUGH"} if moving else {"RUNNING_MODAL"}

    def _take(self, context, event):
        self._typed.take(CHARACTERS.get(event.type, ""))
        text = f"Time of {self._name}: {self._typed.text}_"
        context.area.header_text_set(f"{text}    |    Enter: set   Minus: sign   Esc: leave")

    def _end(self, context):
        if context.area is not None:
            context.area.header_text_set(None)


CLASSES = (MESHKNIT_OT_set_time,)
