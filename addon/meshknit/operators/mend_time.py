"""Make a time field of the modeler's own fit for knitting."""

import bpy

from .. import names, native
from ..core.errors import UsageError
from ..core.knit_surface import check_surface
from ..scene import sessions
from ..scene.time_attribute import publish_time
from .mark_base import MarkOperator, NothingToDo


class MESHKNIT_OT_mend_time(MarkOperator, bpy.types.Operator):
    """Give each opening one time, and remove places away from the openings where knitting would begin or
    end, with the smallest change"""

    bl_idname = names.OP_MEND_TIME
    bl_label = "Mend Time"

    def change(self, context, ob):
        settings = getattr(ob.data, names.PROPERTIES)
        if settings.time_source == "CONSTRAINTS":
            raise UsageError("Times of constraints are not mended: change or remove a constraint")
        if settings.time_source == "ATTRIBUTE":
            self._mend_attribute(context, ob)
        elif settings.time_mend:
            raise NothingToDo("These times are mended already")
        else:
            settings.time_mend = True

    def _mend_attribute(self, context, ob):
        library = native.load()
        model, settings = sessions.read_as_it_is(context, ob)
        knit = check_surface(library, model, settings.stitch_width)
        if not knit.ok:
            raise UsageError("Check the mesh first: it cannot be knit as it is")
        try:
            levelled = library.field_from_values(knit.surface, knit.times_of(model))
        except library.InvalidInput as error:
            raise UsageError(str(error)) from error
        times, _, _ = library.mend_field(knit.surface, levelled)
        publish_time(ob, model, knit.times_for_model(times))


CLASSES = (MESHKNIT_OT_mend_time,)
