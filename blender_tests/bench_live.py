"""How long a person waits for the field: `make bench` prints this table.

blender --background --factory-startup --python blender_tests/bench_live.py"""

import os
import sys
import time
from pathlib import Path

import bpy
import numpy as np

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path[:0] = [os.environ.get("MESHKNIT_ADDONS", str(HERE.parent / "addon")), str(HERE)]

import meshes  # noqa: E402  (after its folder is on the path)
import meshknit  # noqa: E402

meshknit.register()

from meshknit import native  # noqa: E402
from meshknit.core.live_field import make_live_field  # noqa: E402
from meshknit.scene import constraints, live, sessions  # noqa: E402
from meshknit.scene.shapes import add_object, make_mesh  # noqa: E402
from meshknit.scene.shown_field import shown  # noqa: E402

SIZES = (1_000, 10_000, 100_000)
WANTED = "wanted at 10,000: value 16 ms, new chain 50 ms"
REPEATS = 9


def add_tube(vertices):
    """A bulging tube of quads with times on both rims; -> the object"""
    around = int((vertices / 2) ** 0.5)
    along = vertices // around - 1
    places, polygons = meshes.tube(40.0, 200.0, around, along)
    places = np.array(places)
    places[:, :2] *= 1.0 + 0.3 * np.sin(places[:, 2:] / 30.0)
    ob = add_object(bpy.context, make_mesh("Tube", 0.001 * places, polygons))
    for loop, moment in zip(constraints.boundary_loops(ob.data), (-1.0, 1.0)):
        constraints.add_constraint(ob.data, loop, moment)
    sessions.touch(ob)
    settle()
    return ob


def settle():
    bpy.context.view_layer.update()
    while (wait := live.tick()) is not None:
        time.sleep(wait)


def median(action):
    spent = []
    for turn in range(REPEATS):
        began = time.perf_counter()
        action(turn)
        spent.append(1000.0 * (time.perf_counter() - began))
    return sorted(spent)[REPEATS // 2]


def change_value(ob):
    def change(turn):
        ob.data.meshknit.constraints[0].time = -1.0 + 0.05 * (turn + 1)
        live.tick()

    return median(change)


def change_chain(ob):
    """From the changed mesh to the field in its new place, as the timer does it."""
    ring = int((len(ob.data.vertices) / 2) ** 0.5)
    edges = {tuple(sorted(e.vertices)): e.index for e in ob.data.edges}

    def change(turn):
        first = (turn + 2) * ring
        rows = [edges[first + j, first + j + 1] for j in range(ring // 2)]
        if turn == 0:
            constraints.add_constraint(ob.data, rows, 0.2, "Chain")
        else:
            constraints.redraw_constraint(ob.data, 2, rows)
        began = time.perf_counter()
        model, settings = sessions.read_as_it_is(bpy.context, ob)
        library, known = native.load(), dict(sessions.session_of(ob).results)
        field, _ = make_live_field(
            library, model, settings, library.RunContext(), known, shown(ob).live
        )
        times = field.times((-1.0, 1.0, 0.2))
        field.rows(times, settings.stitch_height)
        return 1000.0 * (time.perf_counter() - began)

    return sorted(change(turn) for turn in range(REPEATS))[REPEATS // 2]


def parts(ob):
    """-> (back-solve, rows for the lines), ms"""
    field = shown(ob).live
    solve = median(lambda turn: field.times((-1.0 + 0.01 * turn, 1.0)))
    times = field.times((-1.0, 1.0))
    return solve, median(lambda turn: field.rows(times, 1.73))


def main():
    print("vertices   value ms   (solve   lines)   new chain ms")
    for size in SIZES:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.context.scene.meshknit.live_graph = False
        ob = add_tube(size)
        solve, lines = parts(ob)
        value, chain = change_value(ob), change_chain(ob)
        print(f"{len(ob.data.vertices):8}  {value:9.1f}  {solve:7.1f} {lines:7.1f}   {chain:12.1f}")
    print(WANTED)


main()
sys.stdout.flush()
