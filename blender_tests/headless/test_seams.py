"""Objects whose tubes would have to cross: refused with a proposal, knit in parts where seams are
allowed."""

import json

import bpy
import pytest

import meshes
from objects import add_mesh, session
from test_batch import batch, reason, write

MARKS = meshes.marks((-1.0, (50, 50, 0)), (1.0, (50, 50, 240)))


@pytest.fixture
def lantern(write):
    mesh = write("lantern.obj", meshes.obj_text(*meshes.lantern()))
    return ["--input", mesh, "--scale", 1, "--marks", write("marks.json", MARKS)]


def codes(report):
    return [problem["code"] for problem in report["problems"]]


def test_crossing_tubes_are_refused_and_the_seam_is_proposed(lantern, tmp_path):
    knitout, report = tmp_path / "out.k", tmp_path / "report.json"
    done = batch(*lantern, "--output", knitout, "--report", report)
    assert done.returncode == 1
    assert "cross" in reason(done) and "One seam" in reason(done)
    assert "--allow-seams" in reason(done)
    assert not knitout.exists()
    told = json.loads(report.read_text())
    assert {"seam-needed", "tubes-cross"} <= set(codes(told)) and told["seams"] == []
    (proposal,) = [p for p in told["problems"] if p["code"] == "seam-needed"]
    assert proposal["severity"] == "warning" and proposal["elements"]["nodes"]


def test_with_seams_allowed_the_parts_are_knit_and_the_sheet_says_what_to_sew(lantern, tmp_path):
    paths = {n: tmp_path / f"out.{n}" for n in ("output", "graph", "stitches", "report")}
    options = [x for name, path in paths.items() for x in (f"--{name}", path)]
    done = batch(*lantern, "--allow-seams", *options)
    assert done.returncode == 0, done.stderr
    report = json.loads(paths["report"].read_text())
    assert report["check"]["ok"] and "seam" in codes(report)
    (seam,) = report["seams"]
    x, y, z = seam["at"]
    # Half-way up a corner limb: 20 mm square, in a corner of the 100 mm square.
    assert min(x, 100 - x) == pytest.approx(10, abs=2) and min(y, 100 - y) == pytest.approx(
        10, abs=2
    )
    assert 80 < z < 160
    graph = json.loads(paths["graph"].read_text())
    columns = {tuple(column) for column in graph["columns"]}
    below, above = (set(graph["rows"][row]["nodes"]) for row in seam["rows"])
    assert [len(below), len(above)] == seam["stitches"]
    assert {a for a, _ in seam["columns"]} == below and {b for _, b in seam["columns"]} == above
    assert not columns.intersection(map(tuple, seam["columns"]))
    # What the stitches are held to is the graph that was written.
    stitches = json.loads(paths["stitches"].read_text())["stitches"]
    ends = {s["node"] for s in stitches if s["kind"] == "end"}
    starts = {s["node"] for s in stitches if s["kind"] == "start"}
    assert below <= ends and above <= starts
    assert "To sew" in (tmp_path / "out.output.txt").read_text()


def test_a_click_on_the_proposal_knits_with_seams():
    ob = add_mesh(*meshes.lantern())
    for _ in range(2):
        bpy.ops.meshknit.add_boundary_constraint()
    low, high = sorted(ob.data.meshknit.constraints, key=lambda entry: entry.time)
    assert (low.time, high.time) == (-1.0, 1.0)
    with pytest.raises(RuntimeError, match="cross"):
        bpy.ops.meshknit.schedule()
    assert "seam-needed" in [p["code"] for p in session().problems]
    assert bpy.ops.meshknit.allow_seams() == {"FINISHED"}
    assert bpy.context.scene.meshknit.allow_seams
    assert len(session().report["seams"]) == 1
    assert "seam-needed" not in [p["code"] for p in session().problems]
