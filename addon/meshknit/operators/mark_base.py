"""What the operators of constraints and openings share."""

from bpy.props import FloatProperty, IntProperty

from .. import native, properties
from ..core.errors import UsageError
from ..scene import sessions, undo
from ..scene.edit_mode import active_mesh, object_mode
from .stage_base import poll_mesh


def time_property(of_what):
    return properties.time_property(f"When {of_what} knit", options={"SKIP_SAVE"})


def radius_property(*options):
    return FloatProperty(
        name="Radius (mm)",
        description="How far a round opening reaches, measured along the surface",
        default=15.0,
        min=0.001,
        soft_max=200.0,
        precision=1,
        options=set(options),
    )


def poll_marks(cls, context):
    """True if the active mesh can be marked; says why not where Blender can."""
    if not poll_mesh(cls, context):
        return False
    if active_mesh(context).data.library is not None:
        cls.poll_message_set("The mesh is linked from another file: make it local first")
        return False
    return True


class NothingToDo(Exception):
    """What was asked for is so already. The text says it; scripts go on."""


class MarkOperator:
    """Mixin. Subclasses have change(context, ob), which runs in Object Mode and throws UsageError or
    NothingToDo before it changes anything. `self.editing` says if it is Edit Mode otherwise."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_marks(cls, context)

    def execute(self, context):
        ob = active_mesh(context)
        self.editing = ob.mode == "EDIT"
        try:
            with object_mode(ob):
                self.change(context, ob)
        except NothingToDo as reason:
            self.report({"WARNING"}, str(reason))
            return {"CANCELLED"}
        except (UsageError, native.NativeMissing) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        sessions.touch(ob)
        undo.keep_lists(ob)
        return {"FINISHED"}


class EntryOperator:
    """Mixin for one entry of a list. Subclasses set `marks`, a MarkList."""

    marks = None

    index: IntProperty(name="Index", default=-1, description="-1 is the active one")

    @classmethod
    def poll(cls, context):
        if not poll_marks(cls, context):
            return False
        if not cls.marks.entries(active_mesh(context).data):
            cls.poll_message_set(f"There is no {cls.marks.noun}")
            return False
        return True

    def entry_index(self, mesh):
        """Throws UsageError."""
        index = self.marks.index_of(mesh, self.index)
        if index is None:
            raise UsageError(f"There is no {self.marks.noun} {self.index}")
        return index
