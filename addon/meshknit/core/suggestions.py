"""Set-ups that the library suggests for a model: openings and times, best first."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from .errors import UsageError
from .knit_surface import check_surface, polygons_for_user
from .machines import make_profile
from .model import AT_DIGITS, RADIUS_DIGITS, Constraint, Opening, digest
from .workflow import Outcome, describe, run_stages


@dataclass
class Suggestions:
    """Set-ups for a model, best first, or why there are none."""

    key: str
    entries: tuple = ()  # in the form of report_entry()
    problems: tuple = ()
    message: str = ""
    applied: Optional[int] = None  # the entry that was made the object's own last


def suggestions_key(model, settings):
    """Changes with all that suggestions depend on: not with the model's marks."""
    gauge = (settings.stitch_width, settings.stitch_height, settings.machine)
    return digest("suggest", model.vertices, model.faces, model.face_source, gauge)


def find_suggestions(library, model, settings, context):
    """-> Suggestions, or None if it was cancelled. May run in any thread."""
    key = suggestions_key(model, settings)
    try:
        return Suggestions(key, tuple(suggest(library, model, settings, context)))
    except library.NotKnittable as error:
        problems = tuple(polygons_for_user(model, p) for p in error.problems)
        return Suggestions(key, (), problems, describe(problems) or str(error))
    except (library.InvalidInput, UsageError) as error:
        return Suggestions(key, message=str(error))
    except library.Cancelled:
        return None


def suggest(library, model, settings, context):
    """-> the library's suggestions for the model as it is without any marks of its own, as
    report_entry() has them. Throws the library's NotKnittable, InvalidInput and Cancelled, and
    UsageError for a wrong machine profile."""
    profile = make_profile(library, settings.machine)
    found = library.suggest_marks(
        model.vertices,
        model.faces,
        settings.stitch_width,
        settings.stitch_height,
        profile.needles,
        context=context,
    )
    return [report_entry(suggestion) for suggestion in found]


def with_suggestion(library, model, settings, suggestion):
    """The model with a suggestion's openings and times instead of its own."""
    times = {mark["opening"]: mark["time"] for mark in suggestion["times"] if "opening" in mark}
    openings = tuple(
        Opening(f"Opening {i + 1}", times.get(i), tuple(np.asarray(entry["at"])), entry["radius"])
        for i, entry in enumerate(suggestion["openings"])
    )
    model = replace(
        model, constraints=(), own_time=None, source=None, openings=openings, face_marks=None
    )
    surface = check_surface(library, model, settings.stitch_width).surface
    constraints = []
    for mark in suggestion["times"]:
        if "boundary_near" in mark:
            boundary = surface.boundaries[surface.nearest_boundary(mark["boundary_near"])]
            name = f"Boundary {len(constraints) + 1}"
            rows = tuple(boundary["vertices"])
            constraints.append(Constraint(name, rows, mark["time"], on_surface=True))
    return replace(model, constraints=tuple(constraints))


def run_suggested(library, model, settings, until, context):
    """Runs the stages with each suggestion in turn, until one of them goes all the way.
    -> (model, outcome, the suggestions' entry in the report)"""
    found = find_suggestions(library, model, settings, context)
    if found is None:
        return model, Outcome("cancelled", until, {}, message="cancelled"), None
    if found.message:
        status = "failed" if found.problems else "usage"
        outcome = Outcome(status, until, {}, problems=list(found.problems))
        outcome.message = found.message
        return model, outcome, None
    suggestions = found.entries
    tried = []
    for suggestion in suggestions:
        chosen = with_suggestion(library, model, settings, suggestion)
        outcome = run_stages(library, chosen, settings, until, context)
        tried.append((chosen, outcome))
        if outcome.status != "failed":
            break
    # If none can be knit, the reason is that of the best.
    index = len(tried) - 1 if tried[-1][1].status != "failed" else 0
    model, outcome = tried[index]
    entry = {"chosen": index, "suggestions": list(suggestions)}
    return model, outcome, entry


def report_entry(suggestion):
    """A suggestion in the form of a marks file in mm, with its cost and summary. Lengths are rounded
    to what the marks of a mesh in Blender can hold, so that both say the same."""
    plain = {"format": "meshknit-marks-1", "units": "mm"}
    plain["openings"] = [
        {
            "at": [round(float(x), AT_DIGITS) for x in entry["at"]],
            "radius": round(float(entry["radius"]), RADIUS_DIGITS),
        }
        for entry in suggestion["openings"]
    ]
    plain["times"] = [
        {
            key: [float(x) for x in value] if key == "boundary_near" else value
            for key, value in mark.items()
        }
        for mark in suggestion["times"]
    ]
    plain["summary"] = suggestion["summary"]
    plain["cost"] = suggestion["cost"]
    return plain
