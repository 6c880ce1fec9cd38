"""Set-ups that the library suggests for a model: openings and times, best first."""

from dataclasses import replace

import numpy as np

from .knit_surface import check_surface, polygons_for_user
from .machines import make_profile
from .model import Constraint, Opening
from .workflow import Outcome, describe, run_stages


def suggest(library, model, settings, context):
    """-> the library's suggestions for the model as it is without any marks of its own. Throws the
    library's NotKnittable and Cancelled."""
    profile = make_profile(library, settings.machine)
    return library.suggest_marks(
        model.vertices,
        model.faces,
        settings.stitch_width,
        settings.stitch_height,
        profile.needles,
        context=context,
    )


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
    try:
        suggestions = suggest(library, model, settings, context)
    except library.NotKnittable as error:
        problems = [polygons_for_user(model, p) for p in error.problems]
        outcome = Outcome("failed", until, {}, problems=problems)
        outcome.message = describe(problems) or str(error)
        return model, outcome, None
    except library.Cancelled:
        return model, Outcome("cancelled", until, {}, message="cancelled"), None
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
    entry = {"chosen": index, "suggestions": [report_entry(s) for s in suggestions]}
    return model, outcome, entry


def report_entry(suggestion):
    """A suggestion in the form of a marks file in mm, with its cost and summary."""
    plain = {"format": "meshknit-marks-1", "units": "mm"}
    plain["openings"] = [
        {"at": [float(x) for x in entry["at"]], "radius": float(entry["radius"])}
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
