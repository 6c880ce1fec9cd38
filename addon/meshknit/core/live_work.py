"""What is done in the background while a person works; each may run in any thread and never throws for
the model's faults or cancelling. All take the same, so that one caller starts them all."""

from .guidance import assess
from .live_field import make_live_field
from .workflow import run_stages


def find_field(library, model, settings, run, known, before):
    """-> (LiveField or None, outcome of the check)"""
    return make_live_field(library, model, settings, run, known, before)


def judge(library, model, settings, run, known, before):
    """-> (LiveField or None, Guidance or None, outcome of the time stage). The field once more:
    after changes of times its keys are old, and a rare change may have come under cover of another.
    """
    field, outcome = make_live_field(library, model, settings, run, known, before)
    return field, *assess(library, model, settings, run, {**known, **outcome.results})


def build(library, model, settings, run, known, _before, first_rows):
    """-> outcome of the graph stage"""
    return run_stages(library, model, settings, "graph", run, known, first_rows)
