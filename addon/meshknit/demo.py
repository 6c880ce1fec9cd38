"""The sock, from mesh to machine file and picture:

    blender --background --factory-startup --python addon/meshknit/demo.py -- FOLDER

Leaves sock.blend, sock.k, sock.report.json, sock.graph.json, sock.stitches.json and sock.png in
FOLDER and prints a summary. With --no-picture it leaves out the picture."""

import importlib
import os
import sys
import time
from pathlib import Path


def main(package, arguments):
    """-> exit status"""
    import bpy

    headless = importlib.import_module(f"{package}.headless")
    options = importlib.import_module(f"{package}.core.batch_options")
    folder = Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if not hasattr(bpy.types.Mesh, "meshknit"):
        importlib.import_module(f"{package}.registration").register()
    bpy.ops.meshknit.add_sock()
    # The modeler's file, before anything was built: what the README starts from.
    bpy.context.preferences.filepaths.save_version = 0
    bpy.ops.wm.save_as_mainfile(filepath=str((folder / "sock.blend").absolute()), copy=True)
    files = {name: folder / f"sock.{name}.json" for name in ("report", "graph", "stitches")}
    chosen = [text for name, path in files.items() for text in (f"--{name}", str(path))]
    chosen += ["--output", str(folder / "sock.k"), "--quiet"]
    try:
        model, outcome, report = headless.run(options.parse_options(chosen))
    except headless.UsageError as error:
        headless.say(error)
        return headless.STATUS["usage"]
    if not outcome.ok:
        headless.say(outcome.message)
        return headless.STATUS[outcome.status]
    if "--no-picture" not in arguments:
        began = time.perf_counter()
        picture = importlib.import_module(f"{package}.demo_picture")
        picture.render(bpy.context, model, outcome, folder / "sock.png")
        report["seconds"]["picture"] = time.perf_counter() - began
    print(summary(report, folder), flush=True)
    return 0


def summary(report, folder):
    graph, trace, program = report["graph"], report["trace"], report["program"]
    seconds = ", ".join(f"{stage} {value:.2f}" for stage, value in report["seconds"].items())
    low, high = program["needles"]
    rows = [
        ("stitches", trace["stitches"]),
        ("rows", f"{graph['rows']}, {graph['short_rows']} of them short"),
        ("edges within 10 %", f"{graph['row_error']['within_10']:.1%} of row edges, "
                              f"{graph['column_error']['within_10']:.1%} of column edges"),
        ("passes", f"{program['passes']} ({program['transfers']} transfers)"),
        ("needles", f"{high - low + 1} of each bed ({low} to {high})"),
        ("estimated time", f"{program['estimated_minutes']:.0f} minutes on the machine"),
        ("check", f"{'passed' if report['check']['ok'] else 'FAILED'}: "
                  f"{report['check']['loops']} loops and {report['check']['edges']} yarn edges as traced"),
        ("seconds", seconds),
        ("memory", f"{report.get('peak_mb', 0):.0f} MB at most"),
        ("files", f"{folder}/sock.k, .png, .report.json, .graph.json, .stitches.json, .blend"),
    ]  # fmt: skip
    return "\n".join(["The sock"] + [f"  {name:<18} {value}" for name, value in rows])


if __name__ == "__main__":
    folder = Path(__file__).resolve().parent
    sys.path.insert(0, str(folder.parent))
    status = main(folder.name, sys.argv[sys.argv.index("--") + 1 :])
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
