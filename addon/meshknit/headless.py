"""What batch.py does, once the package is importable."""

import sys
import threading
import traceback
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from . import names, native, registration
from .core.batch_options import parse_options
from .core.errors import UsageError
from .core.files import graph_text, machine_files, report_text, stitches_text, write_whole
from .core.machines import make_profile, read_machine
from .core.marks import read_marks, resolve_marks, resolve_openings
from .core.mesh_files import read_mesh_file
from .core.report import build_report
from .core.suggestions import run_suggested
from .core.workflow import run_stages
from .scene.read_model import read_model
from .scene.settings_io import read_settings
from .scene.shapes import add_object, make_mesh

STATUS = {"done": 0, "failed": 1, "usage": 2, "broken": 3}
SECONDS_BETWEEN_LINES = 2.0


def main(arguments):
    """-> the exit status, after one line on standard error for any but 0."""
    try:
        if not hasattr(bpy.types.Mesh, names.PROPERTIES):
            registration.register()
        options = parse_options(arguments)
        _, outcome, _ = run(options)
    except SystemExit:  # --help
        return 0
    except (UsageError, native.NativeMissing) as error:
        say(str(error))
        return STATUS["usage"]
    except Exception as error:  # our own fault, so with all that helps to find it
        traceback.print_exc()
        say(f"a promise of meshknit broke, please report this: {error}")
        return STATUS["broken"]
    if not outcome.ok:
        say(outcome.message)
    return STATUS[outcome.status]


def say(text):
    print("meshknit: " + " ".join(str(text).split()), file=sys.stderr, flush=True)


def run(options):
    """Runs the stages and writes the files. -> (model, outcome, report). Throws UsageError."""
    library = native.load()
    marks = read_marks(options.marks) if options.marks is not None else None
    with np.errstate(over="ignore", invalid="ignore"):  # the check finds what is not finite
        model = _read_model(options)
    settings = _settings(options, bpy.context.scene)
    profile = make_profile(library, settings.machine)  # a wrong file is found before the work
    if options.kcode is not None and not profile.takes_kcode:
        raise UsageError(f"--kcode goes with --machine kniterate, not {profile.name}")
    suggested = None
    with _progress(library, options.quiet) as run_context:
        known = {}
        if marks is not None:
            openings = resolve_openings(marks, model.scale)
            model = replace(
                model,
                constraints=(),
                own_time=None,
                source=None,
                openings=openings,
                face_marks=None,
            )
            first = run_stages(library, model, settings, "check", run_context)
            if first.ok:
                surface = first.results["check"].value.surface
                model = replace(model, constraints=resolve_marks(marks, surface, model.scale))
            known = first.results
        if options.auto:
            run_auto = run_suggested(library, model, settings, options.until, run_context)
            model, outcome, suggested = run_auto
        else:
            outcome = run_stages(library, model, settings, options.until, run_context, known)
    _add_advice(outcome)
    report = build_report(library, model, settings, outcome)
    if suggested is not None:
        report["suggested"] = suggested
    write_files(options, outcome, report)
    return model, outcome, report


def _read_model(options):
    ob = _find_object(options)
    context = bpy.context
    context.view_layer.update()
    depsgraph = context.evaluated_depsgraph_get()
    return read_model(ob, depsgraph, context.scene, options.scale, options.size)


def _add_advice(outcome):
    """What the stages cannot know: which options help."""
    if any(p["code"] == "too-many-stitches" for p in outcome.problems):
        outcome.message += " Say how large it is with --scale or --size."
    if not outcome.ok:
        for problem in outcome.problems:
            if problem["code"] == "seam-needed":
                outcome.message += f" {problem['message']} Allow it with --allow-seams."


def _settings(options, scene):
    """What the scene says, unless an option says otherwise."""
    if options.machine is not None:
        getattr(scene, names.PROPERTIES).machine_file = ""  # nothing is read that is not used
    settings = read_settings(scene)
    if options.machine is not None:
        settings = replace(settings, machine=read_machine(options.machine))
    if options.stitch_width is not None:
        settings = replace(settings, stitch_width=options.stitch_width)
    if options.stitch_height is not None:
        settings = replace(settings, stitch_height=options.stitch_height)
    if options.no_relax:
        settings = replace(settings, relax=False)
    if options.allow_seams:
        settings = replace(settings, allow_seams=True)
    return settings


def _find_object(options):
    if options.input is not None and Path(options.input).suffix.lower() != ".blend":
        if options.object is not None:
            raise UsageError("--object goes with a .blend file or the open scene")
        vertices, polygons = read_mesh_file(options.input)
        mesh = make_mesh(Path(options.input).stem, vertices, polygons)
        return add_object(bpy.context, mesh)
    if options.input is not None:
        try:
            bpy.ops.wm.open_mainfile(filepath=str(Path(options.input).absolute()))
        except RuntimeError as error:
            raise UsageError(f"cannot read {options.input}: {error}") from error
    return _object_of_scene(options.object)


def _object_of_scene(name):
    scene = bpy.context.scene
    meshes = [ob for ob in scene.objects if ob.type == "MESH"]
    if name is not None:
        ob = scene.objects.get(name)
        if ob not in meshes:
            known = ", ".join(ob.name for ob in meshes) or "none"
            raise UsageError(f"the scene has no mesh object {name}; it has: {known}")
        return ob
    active = bpy.context.view_layer.objects.active
    if active in meshes:
        return active
    if not meshes:
        raise UsageError("the scene has no mesh object")
    if len(meshes) != 1:
        raise UsageError(f"the scene has {len(meshes)} meshes: choose one with --object")
    return meshes[0]


def write_files(options, outcome, report):
    """Whatever the run got to; the machine file only if its check passed, which `emit` says."""
    values = {stage: result.value for stage, result in outcome.results.items()}
    files = [(options.report, report_text(report))]
    if "graph" in values and options.graph is not None:
        files.append((options.graph, graph_text(values["graph"])))
    if "trace" in values and options.stitches is not None:
        files.append((options.stitches, stitches_text(values["trace"])))
    if "emit" in values:
        files += machine_files(values["emit"], options.output, options.kcode)
    failures = []
    for path, text in files:
        if path is not None:
            try:
                write_whole(path, text)
            except UsageError as error:  # the other files, above all the report, are still wanted
                failures.append(str(error))
    if failures:
        raise UsageError("; ".join(failures))


@contextmanager
def _progress(library, quiet):
    """A RunContext whose progress is told on standard error from time to time."""
    run_context, over = library.RunContext(), threading.Event()

    def tell():
        while not over.wait(SECONDS_BETWEEN_LINES):
            say(f"{run_context.progress:.0%}")

    if not quiet:
        threading.Thread(target=tell, daemon=True).start()
    try:
        yield run_context
    finally:
        over.set()
