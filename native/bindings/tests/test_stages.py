"""Every example tube at three gauges, from arrays to a machine file that passes its check."""

import numpy as np
import pytest

from meshknit import native

library = native.load()
GAUGES = [(3.66, 1.73), (2.9, 1.5), (5.0, 2.4)]
TUBES = ("straight_tube", "cone", "bent_tube", "sock")
PROFILE = library.machine_profile("shima_swg091n2")


def constraints_of(surface, shape):
    return [
        (surface.boundaries[surface.nearest_boundary(m["boundary_near"])]["vertices"], m["time"])
        for m in shape["times"]
    ]


def graph_of(shape, width=3.66, height=1.73):
    surface = library.Surface(shape["vertices"], shape["faces"], width)
    time, check = library.solve_time_field(surface, constraints_of(surface, shape))
    return surface, time, check, library.build_knit_graph(surface, time, width, height)


@pytest.mark.parametrize("width, height", GAUGES)
@pytest.mark.parametrize("name", TUBES)
def test_shape_becomes_a_checked_machine_file(name, width, height):
    surface, time, check, graph = graph_of(library.example_shape(name), width, height)
    assert surface.ok and surface.genus == 0 and len(surface.boundaries) == 2
    assert check["extrema"] == 0 and check["saddles"] == check["expected_saddles"] == 0
    assert set(graph.report["properties"].values()) == {0}

    trace = library.trace(graph, PROFILE)
    nodes = trace.nodes[[s["kind"] != "tuck" for s in trace.stitches]]
    # Every node is knit twice.
    assert (np.bincount(nodes, minlength=len(graph.nodes)) == 2).all()

    knitout = library.knitout(trace, library.schedule(trace, PROFILE), PROFILE)
    assert knitout.check["ok"] and knitout.check["errors"] == 0
    again = library.check_knitout(knitout.text, PROFILE, trace)
    assert again["ok"]
    named = {
        line.split("stitch ")[1] for line in knitout.text.splitlines() if ";!source: stitch" in line
    }
    assert named == {str(index) for index in range(len(trace))}


def test_the_same_arrays_give_the_same_bytes():
    def text():
        graph = graph_of(library.sock())[3]
        trace = library.trace(graph, PROFILE)
        return library.knitout(trace, library.schedule(trace, PROFILE), PROFILE).text

    assert text() == text()


def test_the_check_refuses_a_file_with_a_stitch_taken_out():
    trace = library.trace(graph_of(library.straight_tube(20.0, 40.0))[3], PROFILE)
    lines = library.knitout(trace, library.schedule(trace, PROFILE), PROFILE).text.splitlines()
    knits = [i for i, line in enumerate(lines) if line.startswith("knit ")]
    del lines[knits[len(knits) // 2]]
    report = library.check_knitout("\n".join(lines) + "\n", PROFILE, trace)
    assert not report["ok"] and report["problems"][0]["message"]


def test_a_bend_gets_short_rows_and_a_straight_tube_none():
    assert graph_of(library.straight_tube(25.0, 100.0))[3].report["short_rows"] == 0
    bends = [
        graph_of(library.bent_tube(degrees, 25.0, 50.0))[3].report["short_rows"]
        for degrees in (30.0, 90.0)
    ]
    assert 0 < bends[0] < bends[1]


def test_row_edges_are_ready_to_draw():
    graph = graph_of(library.bent_tube(60.0, 25.0, 40.0))[3]
    edges, short = graph.row_edges
    expected = sum(len(r["nodes"]) - (not r["closed"]) for r in graph.rows)
    assert edges.shape == (expected, 2) and short.dtype == bool
    assert short.sum() == sum(len(r["nodes"]) - 1 for r in graph.rows if not r["closed"])


def test_a_live_field_follows_changed_times():
    shape = library.example_shape("cone")
    surface, time, _, _ = graph_of(shape)
    chains = [list(vertices) for vertices, _ in constraints_of(surface, shape)]
    field = library.LiveTimeField(surface, library.FieldWeights(surface), chains)
    np.testing.assert_allclose(field.solve([-1.0, 1.0]), time, atol=1e-9)
    np.testing.assert_allclose(field.solve([-0.5, 0.5]), 0.5 * time, atol=1e-9)


def test_an_example_says_where_to_open_it_and_when_its_rims_are_knit():
    shape = library.example_shape("teddy")
    cut = library.cut_openings(
        shape["vertices"], shape["faces"], [], [(o["at"], o["radius"]) for o in shape["openings"]]
    )
    rims = [cut.openings[mark["opening"]]["rim"] for mark in shape["times"]]
    surface = library.Surface(cut.vertices, cut.faces)
    times = [mark["time"] for mark in shape["times"]]
    _, check = library.solve_time_field(surface, list(zip(rims, times)))
    # 2 g - 2 + b of a sphere with six openings.
    assert check["saddles"] == check["expected_saddles"] == 4
