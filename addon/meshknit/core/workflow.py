"""The stages in order, each keyed by a digest of everything that it depends on.

A stage whose key is already known is not run again; a changed input changes the keys of every later
stage, so that no stale result is ever taken for a fresh one."""

import time
from dataclasses import dataclass, field

from ..names import STAGES
from .errors import UsageError
from .machines import make_profile
from .knit_surface import check_surface
from .model import digest
from .time_sources import sourced_times

# Where each stage ends on the progress bar of a whole run.
ENDS = {"check": 0.03, "time": 0.08, "graph": 0.5, "trace": 0.55, "schedule": 0.8, "emit": 1.0}


@dataclass(frozen=True)
class StageResult:
    """What a stage returned: an object of the library, the problems it noted, its seconds; and
    the model's mm per unit, by which the object goes back to the scene."""

    key: str
    value: object
    seconds: float
    problems: tuple = ()
    scale: float = 1.0


@dataclass
class Outcome:
    """How a run ended: `done`, `failed` (the model's fault), `usage` (a wrong setting), `broken` (a
    promise of ours) or `cancelled`. Results are those of every stage up to the end of the run."""

    status: str
    until: str
    keys: dict
    results: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)
    message: str = ""

    @property
    def ok(self):
        return self.status == "done"


class _Failed(Exception):
    def __init__(self, problems):
        super().__init__()
        self.problems = problems


def stage_keys(model, settings):
    """The key of every stage's result for this model with these settings."""
    # Problems name the user's polygons, and what is drawn is in units of the scene.
    named = (model.face_source, model.scale)
    cuts = [(o.at, o.radius, o.number) for o in model.openings]
    check = digest(
        "check", model.vertices, model.faces, *named, settings.stitch_width, cuts, model.face_marks
    )
    marks = [(c.vertices, c.time, c.on_surface) for c in model.constraints]
    own = model.own_time if model.own_time is not None else marks
    source = model.source.key() if model.source is not None else ()
    field_key = digest("time", check, own, [o.time for o in model.openings], *source)
    gauge = (settings.stitch_width, settings.stitch_height, settings.relax)
    graph = digest("graph", field_key, *gauge, settings.allow_seams)
    trace = digest("trace", graph, settings.machine)  # whose carriers limit the yarns at a time
    schedule = digest("schedule", trace)
    emit = digest("emit", schedule)
    return dict(zip(STAGES, (check, field_key, graph, trace, schedule, emit)))


def run_stages(library, model, settings, until, context, known=None, first_rows=None):
    """Runs every stage up to `until` that `known` (stage -> StageResult) does not already hold.
    `first_rows`, a library's FirstRows, gets the rows of the graph while they are knit.
    Touches nothing but its arguments' own methods, so it may run in any thread. Never throws for
    the model's faults, wrong settings or cancelling: the outcome says so."""
    outcome = Outcome("done", until, stage_keys(model, settings))
    try:
        for stage in STAGES[: STAGES.index(until) + 1]:
            start = ENDS[STAGES[STAGES.index(stage) - 1]] if stage != STAGES[0] else 0.0
            context.begin_stage(start / ENDS[until], ENDS[stage] / ENDS[until])
            result = (known or {}).get(stage)
            if result is None or result.key != outcome.keys[stage]:
                result = _run_stage(library, stage, model, settings, outcome, context, first_rows)
            outcome.results[stage] = result
            outcome.problems += result.problems
            if stage == "check" and not result.value.ok:
                raise _Failed([])
    except _Failed as failure:
        outcome.problems += failure.problems
        outcome.status = "failed"
        outcome.message = describe(outcome.problems)
    except library.NotKnittable as error:
        outcome.problems += [_for_user(outcome, model, p) for p in error.problems]
        outcome.status = "failed"
        outcome.message = describe(outcome.problems) or str(error)
    except library.Cancelled:
        outcome.status, outcome.message = "cancelled", "cancelled"
    except (library.InvalidInput, UsageError) as error:
        outcome.status, outcome.message = "usage", str(error)
    except library.BrokenPromise as error:
        outcome.status = "broken"
        outcome.message = (
            f"{error} (a promise of meshknit broke: please report this with the model)"
        )
    return outcome


def describe(problems):
    """One line for people: the first error's sentence and remedy."""
    errors = [p for p in problems if p["severity"] == "error"]
    if not errors:
        return ""
    text = f"{errors[0]['message']} {errors[0]['remedy']}".strip()
    more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
    return " ".join(text.split()) + more


def _run_stage(library, stage, model, settings, outcome, context, first_rows):
    if context.cancelled:
        raise library.Cancelled()
    before = {name: result.value for name, result in outcome.results.items()}
    before["first rows"] = first_rows
    began = time.perf_counter()
    value, problems = _RUN[stage](library, model, settings, before, context)
    seconds = time.perf_counter() - began
    if stage != "check":
        problems = [_for_user(outcome, model, p) for p in problems]
    return StageResult(outcome.keys[stage], value, seconds, tuple(problems), model.scale)


def _for_user(outcome, model, problem):
    """A problem of a later stage in words and elements of the user's."""
    knit = outcome.results["check"].value
    problem = with_sources(problem, _times(knit, model))
    return knit.for_user(model, knit.with_rim_names(model, problem))


def with_sources(problem, times):
    """A problem whose message says what gives a boundary more than one time. `times` lists
    (name, rows of the surface, time)."""
    if problem["code"] != "boundary-with-two-times":
        return problem
    boundary = set(problem["elements"]["vertices"])
    found = [f"{name} ({time:g})" for name, rows, time in times if boundary.intersection(rows)]
    return {**problem, "message": f"{problem['message']} They come from {', '.join(found)}."}


def _times(knit, model):
    """Everything that gives a time: (name, rows of the surface, time)."""
    times = [
        (c.name, list(c.vertices) if c.on_surface else knit.rows_of(c.vertices), c.time)
        for c in model.constraints
    ]
    rims = [(r.name(model), list(r.vertices), r.time(model)) for r in knit.rims]
    # A constraint may have lain in an opening altogether.
    return [entry for entry in times if entry[1]] + [r for r in rims if r[2] is not None]


def _check(library, model, settings, before, context):
    knit = check_surface(library, model, settings.stitch_width)
    return knit, knit.problems


def _time(library, model, settings, before, context):
    """-> (one time per row of the surface, the field's check)."""
    knit = before["check"]
    chains = [(rows, time) for _, rows, time in _times(knit, model)]
    if model.own_time is not None:
        return _checked(library, knit, model, knit.times_of(model), [])
    if model.source is not None:
        return _checked(library, knit, model, *sourced_times(library, knit, model, chains))
    times, check = library.solve_time_field(knit.surface, chains)
    return (times, check), check["problems"]


def _checked(library, knit, model, times, problems):
    check = library.check_time_field(knit.surface, times)
    problems = problems + check["problems"]
    if any(p["severity"] == "error" for p in problems):
        problems = [knit.with_rim_names(model, p) for p in problems]
        raise _Failed([knit.for_user(model, p) for p in problems])
    return (times, check), problems


def _graph(library, model, settings, before, context):
    graph = library.build_knit_graph(
        before["check"].surface,
        before["time"][0],
        settings.stitch_width,
        settings.stitch_height,
        settings.relax,
        context,
        before["first rows"],
    )
    if settings.allow_seams:
        graph = library.cut_seams(graph)
    return graph, graph.problems


def _trace(library, model, settings, before, context):
    profile = make_profile(library, settings.machine)
    return library.trace(before["graph"], profile, context), ()


def _schedule(library, model, settings, before, context):
    profile = make_profile(library, settings.machine)
    return library.schedule(before["trace"], profile, context), ()


def _emit(library, model, settings, before, context):
    profile = make_profile(library, settings.machine)
    knitout = library.knitout(
        before["trace"], before["schedule"], profile, context, before["graph"]
    )
    return knitout, knitout.problems


_RUN = {
    "check": _check,
    "time": _time,
    "graph": _graph,
    "trace": _trace,
    "schedule": _schedule,
    "emit": _emit,
}
