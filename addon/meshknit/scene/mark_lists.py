"""The two lists of marks on a mesh, constraints and openings, for what is the same with both."""

from dataclasses import dataclass
from typing import Callable

from .. import names
from . import constraints, openings


@dataclass(frozen=True)
class MarkList:
    kind: str  # as in names.MARK_KINDS
    noun: str
    entries_name: str  # of the collection on the mesh's properties
    active_name: str
    remove: Callable  # (mesh, index); needs Object Mode

    def entries(self, mesh):
        return getattr(getattr(mesh, names.PROPERTIES), self.entries_name)

    def active(self, mesh):
        return getattr(getattr(mesh, names.PROPERTIES), self.active_name)

    def select(self, mesh, index):
        """The entry becomes the active one of its list, and its list the one that keys act on."""
        settings = getattr(mesh, names.PROPERTIES)
        setattr(settings, self.active_name, index)
        settings.selected_kind = self.kind

    def index_of(self, mesh, index):
        """-> the index, -1 meaning the active entry, or None if there is none such."""
        index = self.active(mesh) if index < 0 else index
        return index if 0 <= index < len(self.entries(mesh)) else None


CONSTRAINTS = MarkList(
    "CONSTRAINT", "constraint", "constraints", "active", constraints.remove_constraint
)
OPENINGS = MarkList("OPENING", "opening", "openings", "active_opening", openings.remove_opening)
ALL = (CONSTRAINTS, OPENINGS)


def selected_mark(mesh):
    """-> (list, index) of the mark that keys act on, or None. Where its list is empty, the other
    list's active entry."""
    kind = getattr(mesh, names.PROPERTIES).selected_kind
    for marks in sorted(ALL, key=lambda marks: marks.kind != kind):
        index = marks.index_of(mesh, -1)
        if index is not None:
            return marks, index
    return None


def times_of(mesh):
    """Every time that is given to a mark of the mesh."""
    found = [entry.time for entry in CONSTRAINTS.entries(mesh)]
    return found + [entry.time for entry in OPENINGS.entries(mesh) if entry.has_time]


def suggested_time(mesh):
    """For a new boundary or opening: the first is the start, the second the end, more lie between."""
    times = times_of(mesh)
    if -1.0 not in times:
        return -1.0
    return 1.0 if 1.0 not in times else 0.0


def set_time(mesh, marks, index, time):
    """Gives a mark a time; an opening whose rim had none is knit at it from now on."""
    entry = marks.entries(mesh)[index]
    if marks is OPENINGS and not entry.has_time:
        entry.has_time = True
    # Properties are single precision: rounding keeps sums of tenths tenths, and 0 has no sign.
    entry.time = min(1.0, max(-1.0, round(time, 4) + 0.0))
