"""What strokes with the mouse share: they begin with a press, follow the mouse, and end in
execute() as one undo step, or with Esc in nothing."""

from .. import names, native
from ..overlay import stroke
from ..scene import sessions
from ..scene.canvas import canvas_of
from ..scene.edit_mode import active_mesh
from ..scene.mark_lists import suggested_time
from ..scene.pointing import Pointer

NAVIGATION = {
    "MIDDLEMOUSE",
    "WHEELUPMOUSE",
    "WHEELDOWNMOUSE",
    "WHEELINMOUSE",
    "WHEELOUTMOUSE",
    "TRACKPADPAN",
    "TRACKPADZOOM",
    "MOUSEROTATE",
    "MOUSESMARTZOOM",
    "NDOF_MOTION",
    "TIMER",
    "WINDOW_DEACTIVATE",
    *(f"NUMPAD_{digit}" for digit in range(10)),
}
MOVES = {"MOUSEMOVE", "INBETWEEN_MOUSEMOVE"}


def pointer_at(context, event):
    """-> (object, canvas, Pointer) where an event happens; None outside the main region of a 3D view."""
    ob = active_mesh(context)
    if ob is None or context.region_data is None or context.region.type != "WINDOW":
        return None
    context.view_layer.update()
    canvas = canvas_of(ob, context.view_layer.depsgraph)
    mouse = (event.mouse_region_x, event.mouse_region_y)
    return ob, canvas, Pointer(context, ob, canvas, mouse)


def new_time(context, ob, field=None):
    """The time that a new mark gets; `field`: the field's time at its place, for chains."""
    scene = getattr(context.scene, names.PROPERTIES)
    if scene.new_time_from == "VALUE":
        return scene.new_time
    return suggested_time(ob.data) if field is None else field


class StrokeOperator:
    """Mixin, before MarkOperator. Subclasses have begin(context, event, ob, canvas, pointer) -> a
    set to return instead of starting, or None; follow(context, event, ob, canvas, pointer), called
    for every move; text(), for the header; finish(context) -> what modal() returns."""

    confirm = ("LEFTMOUSE", "RELEASE")
    keys = ""

    def invoke(self, context, event):
        try:
            found = pointer_at(context, event)
            if found is None:
                self.report({"WARNING"}, "Point at the surface in a 3D view")
                return {"CANCELLED"}
            instead = self.begin(context, event, *found)
        except native.NativeMissing as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if instead is not None:
            return instead
        self._object, self._mode, self._canvas = found[0].name, found[0].mode, found[1]
        self._show(context)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if not self._is_still_there(context):
            self._end(context)
            self.report({"WARNING"}, f"{self._object} is gone, or in another mode")
            return {"CANCELLED"}
        if event.type in {"ESC", "RIGHTMOUSE"} and event.value == "PRESS":
            self._end(context)
            return {"CANCELLED"}
        if event.type in MOVES:
            ob = active_mesh(context)
            mouse = (event.mouse_region_x, event.mouse_region_y)
            pointer = Pointer(context, ob, self._canvas, mouse)
            self.follow(context, event, ob, self._canvas, pointer)
            self._show(context)
            return {"RUNNING_MODAL"}
        confirmed = event.type in {"RET", "NUMPAD_ENTER"} and event.value == "PRESS"
        if confirmed or (event.type, event.value) == self.confirm:
            self._end(context)
            return self.finish(context)
        return {"PASS_THROUGH"} if event.type in NAVIGATION else {"RUNNING_MODAL"}

    def cancel(self, context):
        """Blender closes, or loads another file, in mid-stroke."""
        stroke.clear()

    def _is_still_there(self, context):
        ob = active_mesh(context)
        there = ob is not None and (ob.name, ob.mode) == (self._object, self._mode)
        return there and context.area is not None and context.region_data is not None

    def _show(self, context):
        context.area.header_text_set(f"{self.text()}    |    {self.keys}")
        sessions.redraw(context)

    def _end(self, context):
        stroke.clear()
        if context.area is not None:
            context.area.header_text_set(None)
        sessions.redraw(context)
