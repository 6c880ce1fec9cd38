"""The options of a headless run."""

import argparse
import os
from pathlib import Path

from ..names import STAGES
from .errors import UsageError
from .files import sheet_of, target_of
from .mesh_files import SUFFIXES


OUTPUTS = ("output", "kcode", "graph", "stitches", "report")
MACHINE_FILES = ("output", "kcode")  # each gets a run sheet
INPUTS = ("input", "marks", "machine")


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(message)


def parse_options(arguments):
    """Throws UsageError."""
    options = _make_parser().parse_args(arguments)
    for name in INPUTS + OUTPUTS + ("object",):
        if getattr(options, name) == "":
            raise UsageError(f"--{name} needs a name")
    if options.auto and options.marks is not None:
        raise UsageError("give --marks or --auto, not both")
    for name in ("scale", "size", "stitch_width", "stitch_height"):
        value = getattr(options, name)
        if value is not None and not 0.0 < value < float("inf"):
            raise UsageError(f"--{name.replace('_', '-')} must be a length above 0")
    if options.scale is not None and options.size is not None:
        raise UsageError("give --scale or --size, not both")
    if options.input is not None:
        suffix = Path(options.input).suffix.lower()
        if suffix not in SUFFIXES + (".blend",):
            raise UsageError(f"--input must be one of {', '.join(SUFFIXES)}, .blend")
    _require_outputs(options)
    return options


def _require_outputs(options):
    needed = {"graph": "graph", "stitches": "trace", "output": "emit", "kcode": "emit"}
    for option, stage in needed.items():
        wanted = getattr(options, option)
        if wanted is not None and STAGES.index(options.until) < STAGES.index(stage):
            raise UsageError(f"--{option} needs the stage {stage}, after --until {options.until}")
    inputs = [getattr(options, name) for name in INPUTS]
    taken = {os.path.normcase(os.path.realpath(path)) for path in inputs if path is not None}
    for option in OUTPUTS:
        wanted = getattr(options, option)
        if wanted is None:
            continue
        wanted_files = [wanted] + ([sheet_of(wanted)] if option in MACHINE_FILES else [])
        for file in wanted_files:
            target = os.path.normcase(target_of(file))
            if target in taken:
                raise UsageError(f"--{option}: {file} is the file of another option, too")
            taken.add(target)


def _make_parser():
    parser = _Parser(
        prog="blender --background [scene.blend] --python batch.py --",
        description="From a mesh to a checked program for a knitting machine.",
        allow_abbrev=False,
    )
    add = parser.add_argument
    add("--input", metavar="FILE", help=".obj .ply .stl, or .blend; left out: the open scene")
    add("--object", metavar="NAME", help="default: the active object, or the only mesh")
    add("--scale", type=float, metavar="S", help="millimetres per unit of the file")
    add("--size", type=float, metavar="MM", help="length of the finished object's longest side")
    add("--marks", metavar="FILE", help="openings and times; default: those stored on the object")
    add("--auto", action="store_true", help="choose openings and times without any marks")
    add("--machine", metavar="NAME", default=None, help="a machine profile, or a profile file")
    add("--stitch-width", type=float, metavar="MM", help="default 3.66")
    add("--stitch-height", type=float, metavar="MM", help="default 1.73")
    add("--no-relax", action="store_true", help="leave the stitches where peeling put them")
    add("--allow-seams", action="store_true", help="cut tubes that would have to cross, to be sewn")
    add("--output", metavar="FILE.k", help="knitout, written if the independent check passed")
    add("--kcode", metavar="FILE.kc", help="Kniterate's own file (machine kniterate only)")
    add("--graph", metavar="FILE.json", help="rows and columns of the knit graph")
    add("--stitches", metavar="FILE.json", help="the traced stitches, in the order of knitting")
    add("--report", metavar="FILE.json", help="numbers and problems of every stage")
    add("--until", choices=STAGES, default=STAGES[-1], help="stop after this stage")
    add("--quiet", action="store_true", help="no progress on standard error")
    return parser
