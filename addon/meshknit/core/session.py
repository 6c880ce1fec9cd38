"""The results that one object has, and whether they still belong to it."""

from dataclasses import dataclass, field
from itertools import count

from ..names import STAGES


_serials = count()


@dataclass
class Session:
    """Results by stage. They are fresh while the keys of the object as it is now are theirs."""

    results: dict = field(default_factory=dict)
    keys: dict = field(default_factory=dict)  # of the object as last looked at
    problems: list = field(default_factory=list)
    report: dict = field(default_factory=dict)
    message: str = ""  # of the last run, if it did not reach its end
    unreadable: str = ""  # why the object, or the settings, cannot be read as they are now
    first_rows: tuple = None  # (rows of a graph that is being made, mm per unit of the scene)
    guidance: object = None  # guidance.Guidance, once the field was judged
    suggestions: object = None  # suggestions.Suggestions, once they were asked for
    written: str = ""  # the machine file's full path, once it is there
    revision: int = 0  # grows with every change that a drawing must follow
    serial: int = field(default_factory=lambda: next(_serials))  # of all sessions, this one

    @property
    def drawing_key(self):
        """Changes with everything that a drawing must follow, also from object to object and from
        file to file."""
        return self.serial, self.revision

    def adopt(self, outcome, report):
        """Takes over a run. A cancelled run leaves the session as it was."""
        if outcome.status == "cancelled":
            return
        self.results.update(outcome.results)
        self.problems = list(outcome.problems)
        self.report = report
        self.message, self.unreadable = outcome.message, ""
        self.look_at(outcome.keys)
        self.revision += 1

    def untold(self):
        """What went wrong and stands in no problem of the list, for people."""
        told = any(problem["severity"] == "error" for problem in self.problems)
        return self.unreadable or ("" if told else self.message)

    def keep(self, outcome):
        """Takes over the results of a run in passing: what the report and the list of problems say
        stays."""
        if any(self.results.get(s) is not result for s, result in outcome.results.items()):
            self.results.update(outcome.results)
            self.revision += 1
        self.look_at(outcome.keys)

    def show_first_rows(self, rows):
        """Rows of a graph that is being made, or None when that has ended."""
        if rows is not self.first_rows:
            self.first_rows = rows
            self.revision += 1

    def shown_graph(self):
        """-> (graph, mm per unit of the scene, whether it is out of date) to be drawn, or None."""
        if self.first_rows is not None:
            return *self.first_rows, False
        result = self.results.get("graph")
        return (result.value, result.scale, not self.is_fresh("graph")) if result else None

    def look_at(self, keys):
        """Says which keys the object has now."""
        if keys != self.keys:
            self.keys = dict(keys)
            self.revision += 1

    def lose_sight(self, why):
        """Says that the object, or the settings, cannot be read as they are now."""
        self.unreadable = why
        self.look_at({})

    def value(self, stage):
        """The stage's last result, fresh or not; None before its first run."""
        result = self.results.get(stage)
        return result.value if result else None

    def is_fresh(self, stage):
        result = self.results.get(stage)
        return result is not None and result.key == self.keys.get(stage)

    def is_guidance_fresh(self):
        return self.guidance is not None and self.guidance.key == self.keys.get("time")

    def stale_stages(self):
        return [s for s in STAGES if s in self.results and not self.is_fresh(s)]
