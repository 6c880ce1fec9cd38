"""What there is to know about a model before its graph is built: numbers, saddles, and findings, each
with what to do about it."""

from dataclasses import dataclass

import numpy as np

from .errors import UsageError
from .knit_surface import polygons
from .machines import make_profile
from .row_levels import FieldGeometry
from .live_field import COURSES_IN_ROW
from .workflow import run_stages

SLOW = 1.2  # where time steps this much slower than in the middle of its row, there are short rows
STILL = 4.0  # and from here on rows do not reach it
WORTH_A_WORD = 0.005  # of the area

# What a click can do about a finding.
GIVE_TIME, MEND, SELECT, SUGGEST = "GIVE_TIME", "MEND", "SELECT", "SUGGEST"
_MENDABLE = ("false-extremum", "boundary-not-constant", "boundary-in-passing")
_REMEDIES = {
    "boundary-without-time": (GIVE_TIME, SELECT),
    "boundary-with-two-times": (SELECT,),
    "contradictory-times": (SELECT,),
    "boundary-in-passing": (SELECT, SUGGEST),
    "false-extremum": (SELECT, SUGGEST),
    "all-times-equal": (SUGGEST,),
    "no-start": (SUGGEST,),
    "no-end": (SUGGEST,),
    "too-few-boundaries": (SELECT, SUGGEST),
    "time-stands-still": (SELECT, SUGGEST),
}


@dataclass(frozen=True)
class Saddle:
    """A place where tubes part or meet."""

    place: tuple  # in units of the scene
    time: float
    below: int  # tubes
    above: int

    def text(self):
        if self.below == 1:
            return f"splits into {self.above}"
        if self.above == 1:
            return f"{self.below} merge into one"
        return f"{self.below} tubes become {self.above}"


@dataclass(frozen=True)
class Guidance:
    key: str  # of the time field that it is about
    problems: tuple = ()  # in the form of a library's problem, each with "actions"
    saddles: tuple = ()  # of Saddle
    numbers: tuple = ()  # (name, value) for people


def assess(library, model, settings, context, known=None):
    """-> (Guidance, outcome of the time stage); (None, outcome) if it was cancelled. May run in any
    thread. Never throws for the model's faults or cancelling."""
    outcome = run_stages(library, model, settings, "time", context, known)
    if outcome.status == "cancelled":
        return None, outcome
    problems = [_with_actions(model, problem) for problem in outcome.problems]
    if outcome.status in ("usage", "broken"):
        problems.append(_not_judged(outcome.message))
    if not outcome.ok:
        return Guidance(outcome.keys["time"], tuple(problems)), outcome
    try:
        profile = make_profile(library, settings.machine)
    except UsageError as error:
        problems.append(_not_judged(str(error)))
        return Guidance(outcome.keys["time"], tuple(problems)), outcome
    knit, times = (outcome.results[s].value for s in ("check", "time"))
    gauge = (settings.stitch_width, settings.stitch_height, profile.needles)
    try:
        cost = library.judge_field(knit.surface, times[0], *gauge, context)
    except library.Cancelled:
        return None, outcome
    problems += _slow_parts(model, knit, cost)
    problems += _machine_limits(cost, profile)
    saddles = tuple(
        Saddle(tuple(np.asarray(s["at"]) / model.scale), s["time"], s["below"], s["above"])
        for s in cost["saddles"]
    )
    rows = FieldGeometry(*knit.arrays(model)).row_numbers(
        times[0], COURSES_IN_ROW * settings.stitch_height
    )
    numbers = (
        ("Rows", f"about {rows.max():.0f}"),
        ("Stitches", f"about {_rounded(cost['stitches'])}"),
        ("Needles", f"{cost['needles']:.0f} of {profile.needles}"),
        ("Shaping", f"about {_rounded(cost['shaping'])}"),
        ("Short rows", f"about {_rounded(cost['short_rows'])}"),
    )
    return Guidance(outcome.keys["time"], tuple(problems), saddles, numbers), outcome


def _with_actions(model, problem):
    actions = _REMEDIES.get(problem["code"], (SELECT,))
    of_its_own = model.own_time is not None or (model.source is not None and not model.source.mend)
    if of_its_own and problem["code"] in _MENDABLE:
        actions = (MEND, *actions)
    if not problem["elements"]:
        actions = tuple(a for a in actions if a != SELECT)
    return {**problem, "actions": actions}


def _finding(code, severity, message, remedy, faces, actions):
    elements = {"faces": list(faces)} if len(faces) else {}
    found = {"code": code, "severity": severity, "message": message, "remedy": remedy}
    return {**found, "elements": elements, "actions": actions}


def _not_judged(why):
    return _finding("not-judged", "error", why, "", (), ())


def _slow_parts(model, knit, cost):
    vertices, faces = knit.arrays(model)
    rows = np.asarray(cost["slowness_faces"])
    slowness = np.asarray(cost["slowness"])
    corners = vertices[faces[rows]]
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.sqrt((sides * sides).sum(axis=1))
    parts = (
        (
            "short-rows-ahead", "note", (slowness > SLOW) & (slowness <= STILL),
            "On {:.0%} of the surface time steps slower than beside it: rows will be short there.",
            "Nothing need be done. For fewer short rows let times follow the distance along the "
            "surface.",
        ),
        (
            "rows-do-not-reach", "warning", slowness > STILL,
            "On {:.0%} of the surface time nearly stands still: rows may not reach it.",
            "Make an opening there, or lay a constraint through it with a time of its own.",
        ),
    )  # fmt: skip
    for code, severity, chosen, message, remedy in parts:
        share = areas[chosen].sum() / max(areas.sum(), 1e-300)
        if share >= WORTH_A_WORD:
            kept = rows[chosen] if knit.cut is None else knit.cut.source_face[rows[chosen]]
            named = polygons(model, np.unique(kept))
            actions = (SELECT,) if severity == "note" else (SELECT, SUGGEST)
            yield _finding(code, severity, message.format(share), remedy, named, actions)


def _machine_limits(cost, profile):
    if not cost["fits"]:
        yield _finding(
            "wider-than-the-bed",
            "error",
            f"The widest rows need about {cost['needles']:.0f} needles; the bed has "
            f"{profile.needles}.",
            "Make the object smaller or the stitches wider, or let parts that are knit side by "
            "side follow one another.",
            (),
            (SUGGEST,),
        )
    if not cost["can_hang"]:
        yield _finding(
            "tubes-would-cross",
            "error",
            "The tubes cannot hang side by side without crossing.",
            "Other times or openings make other tubes: let another end be knit first.",
            (),
            (SUGGEST,),
        )
    if cost["tangled"]:
        yield _finding(
            "tangled-saddles",
            "error",
            "Tubes part and meet at the same time, which no row can step over.",
            "Move the times of the boundaries apart, so that one happens after the other.",
            (),
            (SUGGEST,),
        )


def _rounded(number):
    """To two digits: it is an estimate."""
    digits = max(len(str(int(number))) - 2, 0)
    return int(round(number, -digits)) if digits else int(round(number))
