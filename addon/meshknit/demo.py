"""The sock, from mesh to machine file and picture:

    blender --background --factory-startup --python addon/meshknit/demo.py -- FOLDER

Leaves sock.blend, sock.k, sock.k.txt, sock.report.json, sock.graph.json, sock.stitches.json and
sock.png in FOLDER and prints a summary; `-- FOLDER --no-picture` leaves out the picture. With

    blender --factory-startup --python addon/meshknit/demo.py -- --gui

Blender opens with the add-on on and the sock in the scene, ready to knit."""

import importlib
import os
import sys
import time
from pathlib import Path


def load_sock(package):
    """An empty scene with the sock in it, as Add > Mesh > Knit > Sock makes it."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    if not hasattr(bpy.types.Mesh, "meshknit"):
        importlib.import_module(f"{package}.registration").register()
    bpy.ops.meshknit.add_sock()


def knit(package, folder, with_picture):
    """-> exit status"""
    import bpy

    headless = importlib.import_module(f"{package}.headless")
    options = importlib.import_module(f"{package}.core.batch_options")
    folder.mkdir(parents=True, exist_ok=True)
    bpy.context.preferences.filepaths.save_version = 0
    bpy.ops.wm.save_as_mainfile(filepath=str((folder / "sock.blend").absolute()), copy=True)
    chosen = ["--quiet", "--output", str(folder / "sock.k")]
    for name in ("report", "graph", "stitches"):
        chosen += [f"--{name}", str(folder / f"sock.{name}.json")]
    try:
        model, outcome, report = headless.run(options.parse_options(chosen))
    except headless.UsageError as error:
        headless.say(error)
        return headless.STATUS["usage"]
    if not outcome.ok:
        headless.say(outcome.message)
        return headless.STATUS[outcome.status]
    if with_picture:
        began = time.perf_counter()
        picture = importlib.import_module(f"{package}.demo_picture")
        picture.render(bpy.context, model, outcome, folder / "sock.png")
        report["seconds"]["picture"] = time.perf_counter() - began
    print(summary(report, folder), flush=True)
    return 0


def open_window(package):
    """The sock in the view, the sidebar open."""
    import bpy

    load_sock(package)
    bpy.context.preferences.view.show_splash = False

    def arrange():
        window = bpy.context.window_manager.windows[0]
        area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
        area.spaces.active.show_region_ui = True
        region = next(r for r in area.regions if r.type == "WINDOW")
        with bpy.context.temp_override(window=window, area=area, region=region):
            bpy.ops.view3d.view_axis(type="FRONT")
            bpy.ops.view3d.view_selected()

    bpy.app.timers.register(arrange, first_interval=0.5)


def summary(report, folder):
    graph, trace, program = report["graph"], report["trace"], report["program"]
    low, high = program["needles"]
    within = [f"{graph[kind]['within_10']:.1%}" for kind in ("row_error", "column_error")]
    check = report["check"]
    verdict = "passed" if check["ok"] else "FAILED"
    lines = (
        ("stitches", trace["stitches"]),
        ("rows", f"{graph['rows']}, {graph['short_rows']} of them short"),
        ("lengths", f"{within[0]} of row edges and {within[1]} of columns within 10 %"),
        ("passes", f"{program['passes']} with {program['transfers']} transfers"),
        ("needles", f"{high - low + 1} of each bed, {low} to {high}"),
        ("estimate", f"{program['estimated_minutes']:.0f} minutes on the machine"),
        ("check", f"{verdict}: {check['loops']} loops and {check['edges']} edges as traced"),
        ("seconds", ", ".join(f"{s} {value:.2f}" for s, value in report["seconds"].items())),
        ("memory", f"{report.get('peak_mb', 0):.0f} MB at most"),
        ("files", f"{folder}/sock.k .k.txt .report.json .graph.json .stitches.json .blend .png"),
    )
    return "\n".join(["The sock:"] + [f"  {name:<10} {text}" for name, text in lines])


if __name__ == "__main__":
    source = Path(__file__).resolve().parent
    sys.path.insert(0, str(source.parent))
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    if "--gui" in arguments:
        open_window(source.name)
    else:
        load_sock(source.name)
        status = knit(source.name, Path(arguments[0]), "--no-picture" not in arguments)
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
