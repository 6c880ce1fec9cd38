"""The headless run as scripts see it: files, exit status, one line of reason."""

import json
import subprocess
import time
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest

import meshes
from meshknit import headless
from objects import add_mesh

BATCH = Path(__file__).resolve().parents[2] / "addon" / "meshknit" / "batch.py"
TUBE_MARKS = meshes.marks((-1.0, (0, 0, 0)), (1.0, (0, 0, 60)))


def batch(*options, scene=None):
    command = [bpy.app.binary_path, "--background", "--factory-startup"]
    command += [str(scene)] if scene else []
    command += ["--python", str(BATCH), "--", "--quiet", *map(str, options)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert (done.returncode == 3) or "Traceback" not in done.stderr + done.stdout, done.stderr
    return done


def reason(done):
    """The one line on standard error."""
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("meshknit: ")]
    return line


@pytest.fixture
def write(tmp_path):
    def write(name, content):
        path = tmp_path / name
        text = content if isinstance(content, str) else json.dumps(content)
        path.write_text(text)
        return path

    return write


@pytest.fixture
def tube(write):
    return write("tube.obj", meshes.obj_text(*meshes.tube()))


@pytest.fixture
def tube_marks(write):
    return write("marks.json", TUBE_MARKS)


def test_from_a_file_to_all_outputs(tube, tube_marks, tmp_path):
    paths = {n: tmp_path / f"out.{n}" for n in ("output", "graph", "stitches", "report")}
    options = [x for name, path in paths.items() for x in (f"--{name}", path)]
    done = batch("--input", tube, "--scale", 1, "--marks", tube_marks, *options)
    assert done.returncode == 0, done.stderr
    assert not [line for line in done.stderr.splitlines() if line.startswith("meshknit")]
    report = json.loads(paths["report"].read_text())
    assert report["format"] == "meshknit-report-1" and report["ok"] and report["problems"] == []
    stages = {"check", "time", "graph", "trace", "schedule", "emit", "total"}
    assert set(report["seconds"]) == stages and report["peak_mb"] > 10
    assert report["mesh"]["boundaries"] == 2 and report["mesh"]["scale"] == 1.0
    graph = json.loads(paths["graph"].read_text())
    assert graph["format"] == "meshknit-graph-1" and graph["stitch_width"] == 3.66
    assert len(graph["nodes"]) == report["graph"]["nodes"]
    assert [len(r["nodes"]) for r in graph["rows"]] == [len(r) for r in graph["row_lengths"]]
    assert len(graph["columns"]) == len(graph["column_lengths"])
    stitches = json.loads(paths["stitches"].read_text())["stitches"]
    assert len(stitches) == report["trace"]["stitches"]
    for index, stitch in enumerate(stitches):
        assert all(index in stitches[parent]["children"] for parent in stitch["parents"])
    knitout = paths["output"].read_text()
    assert f";!source: stitch {len(stitches) - 1}" in knitout
    assert sorted(p.name for p in tmp_path.iterdir() if p.name.startswith(".")) == []


def test_the_same_run_writes_the_same_bytes(tube, tube_marks, tmp_path):
    texts = []
    for name in ("a.k", "b.k"):
        options = ("--input", tube, "--scale", 1, "--marks", tube_marks)
        assert batch(*options, "--output", tmp_path / name).returncode == 0
        texts.append((tmp_path / name).read_bytes())
    assert texts[0] == texts[1]


def test_stored_constraints_of_a_scene_are_used(tmp_path):
    bpy.ops.meshknit.add_bent_tube()
    bpy.ops.mesh.primitive_cube_add()
    scene = tmp_path / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(scene))
    report = tmp_path / "report.json"
    options = ("--object", "Bent Tube", "--report", report)
    for more, opened in ([], scene), (["--input", scene], None):
        done = batch(*more, *options, scene=opened)
        assert done.returncode == 0, done.stderr
        assert json.loads(report.read_text())["graph"]["short_rows"] > 0
        report.unlink()
    assert "Bent Tube" in reason(batch("--object", "Sock", scene=scene))


def test_size_gauge_and_until(tube, tube_marks, tmp_path):
    report = tmp_path / "report.json"
    options = ("--input", tube, "--marks", tube_marks, "--size", 120, "--until", "graph")
    done = batch(*options, "--stitch-width", 5, "--stitch-height", 2.4, "--report", report)
    assert done.returncode == 0
    data = json.loads(report.read_text())
    assert data["mesh"]["scale"] == pytest.approx(2.0)  # both sides are 60 units long
    assert "graph" in data and "trace" not in data
    assert data["graph"]["rows"] == pytest.approx(120.0 / 4.8, abs=2)


def test_relaxing_is_on_unless_the_scene_or_an_option_says_otherwise(tmp_path):
    bpy.ops.meshknit.add_bent_tube()
    scenes = {relax: tmp_path / f"{relax}.blend" for relax in (True, False)}
    for relax, path in scenes.items():
        bpy.context.scene.meshknit.relax = relax
        bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
    graph = tmp_path / "graph.json"

    def graph_of(scene, *options):
        done = batch("--until", "graph", "--graph", graph, *options, scene=scene)
        assert done.returncode == 0, done.stderr
        return json.loads(graph.read_text())

    relaxed, peeled = graph_of(scenes[True]), graph_of(scenes[True], "--no-relax")
    assert peeled["nodes"] != relaxed["nodes"] and peeled["columns"] == relaxed["columns"]
    assert graph_of(scenes[False]) == peeled


def test_the_files_unit_is_the_scenes_unit(write, tmp_path):
    vertices, polygons = meshes.tube()
    small = write("small.obj", meshes.obj_text(vertices * 0.001, polygons))
    marks = write("m.json", meshes.marks((-1.0, (0, 0, 0)), (1.0, (0, 0, 0.06))))
    done = batch("--input", small, "--marks", marks, "--report", tmp_path / "r.json")
    assert done.returncode == 0
    assert json.loads((tmp_path / "r.json").read_text())["mesh"]["scale"] == 1000.0


NARROW = {"based_on": "shima_swg091n2", "needles": 40}
NO_KNIT = {
    "empty": (([], []), TUBE_MARKS, "no faces"),
    "moebius": (meshes.moebius(), TUBE_MARKS, ""),
    "hourglass": (meshes.hourglass(), TUBE_MARKS, ""),
    "one boundary": (meshes.disk(), TUBE_MARKS, ""),
    "contradictory times": (
        meshes.tube(),
        meshes.marks((-1.0, (0, 0, 0)), (1.0, (0, 0, 60)), (0.5, (30, 0, 0))),
        "",
    ),
    "boundary without time": (meshes.tube(), meshes.marks((-1.0, (0, 0, 0))), ""),
}


@pytest.mark.parametrize("case", NO_KNIT)
def test_what_cannot_be_knit_ends_with_1_and_a_report(case, write, tmp_path):
    mesh, marks, words = NO_KNIT[case]
    old = write("old.k", "an older file")
    report = tmp_path / "report.json"
    done = batch(
        "--input", write("m.obj", "o m\n" + meshes.obj_text(*mesh)), "--scale", 1,
        "--marks", write("m.json", marks), "--report", report, "--output", old,
    )  # fmt: skip
    assert done.returncode == 1
    assert words in reason(done) and len(reason(done)) > 40
    data = json.loads(report.read_text())
    assert data["ok"] is False
    errors = [p for p in data["problems"] if p["severity"] == "error"]
    assert errors and all(p["code"] and p["message"] and p["remedy"] for p in errors)
    if case != "empty":
        assert any(p["elements"] for p in errors)
    assert old.read_text() == "an older file"


def test_a_machine_that_is_too_narrow_says_how_far_to_scale(tube, tube_marks, write, tmp_path):
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks,
        "--machine", write("narrow.json", NARROW), "--stitches", tmp_path / "s.json",
    )  # fmt: skip
    assert done.returncode == 1 and "%" in reason(done)
    assert (tmp_path / "s.json").exists()  # tracing was done


@pytest.mark.parametrize(
    "options, words",
    [
        (["--input", "{folder}/missing.obj"], "missing.obj"),
        (["--input", "{folder}/noise.obj"], "noise.obj"),
        (["--input", "{folder}/noise.blend"], "noise.blend"),
        (["--input", "{folder}/tube.obj", "--marks", "{folder}/noise.obj"], "marks"),
        (["--input", "{folder}/tube.obj", "--marks", "{folder}/openings.json"], "openings[0]"),
        (["--input", "{folder}/tube.obj", "--auto", "--marks", "x.json"], "not both"),
        (["--input", "{folder}/tube.obj", "--kcode", "{folder}/x.kc"], "--machine kniterate"),
        (["--input", "{folder}/tube.obj", "--machine", "loom"], "loom"),
        (["--input", "{folder}/tube.obj", "--machine", "{folder}/typo.json"], "nedles"),
        (["--colour"], "colour"),
        ([], "no mesh object"),
        (["--input", "{folder}/tube.obj", "--marks", "{folder}/five.json"], "at least one time"),
        (["--input", "{folder}/tube.obj", "--machine", "{folder}/one.json"], "20 to 2000"),
        (["--input", "{folder}/tube.obj", "--output", "{folder}/no/x.k"], "does not exist"),
    ],
)
def test_wrong_usage_ends_with_2_and_one_line(options, words, tube, write, tmp_path):
    write("noise.obj", "\x01\x02 this is no mesh\n")
    write("noise.blend", "this is no scene")
    write("typo.json", {"based_on": "shima_swg091n2", "nedles": 40})
    write("five.json", {**TUBE_MARKS, "times": 5})
    write("one.json", {"based_on": "shima_swg091n2", "needles": 1})
    write("openings.json", {**TUBE_MARKS, "openings": [{"at": [0, 0, 0], "radius": 0.0}]})
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "empty.blend"))
    scene = None if options else tmp_path / "empty.blend"
    done = batch(*[option.format(folder=tmp_path) for option in options], scene=scene)
    assert done.returncode == 2
    assert words in reason(done)


BALL_MARKS = {
    "format": "meshknit-marks-1",
    "units": "mm",
    "openings": [{"at": [0, 0, -50], "radius": 20.0}, {"at": [0, 0, 50], "radius": 15.0}],
    "times": [{"time": -1.0, "opening": 0}, {"time": 1.0, "opening": 1}],
}


def test_a_closed_ball_is_knit_by_openings_of_a_marks_file(write, tmp_path):
    ball = write("ball.obj", meshes.obj_text(*meshes.ball()))
    options = ("--input", ball, "--scale", 1, "--report", tmp_path / "r.json")
    done = batch(
        *options, "--marks", write("m.json", BALL_MARKS), "--output", tmp_path / "ball.k"
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["check"]["ok"] and report["mesh"]["boundaries"] == 2
    assert [o["time"] for o in report["openings"]] == [-1.0, 1.0]
    assert [o["radius"] for o in report["openings"]] == [20.0, 15.0]
    assert ";!source: stitch 0" in (tmp_path / "ball.k").read_text()
    small = {
        **BALL_MARKS,
        "openings": [{"at": [0, 0, -50], "radius": 2.0}, BALL_MARKS["openings"][1]],
    }
    done = batch(*options, "--marks", write("small.json", small))
    assert done.returncode == 1 and "at least" in reason(done)
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["ok"] is False and report["problems"][0]["code"] == "opening-too-small"


def test_a_marks_file_replaces_the_openings_of_the_scene(write, tmp_path):
    add_mesh(*meshes.ball())
    bpy.ops.meshknit.add_opening(location=(0.05, 0, 0), radius=20.0)
    scene = tmp_path / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(scene))
    report = tmp_path / "r.json"
    options = ("--until", "time", "--report", report)
    assert batch(*options, "--marks", write("m.json", BALL_MARKS), scene=scene).returncode == 0
    assert len(json.loads(report.read_text())["openings"]) == 2
    assert batch(*options, scene=scene).returncode == 1  # one opening only


def test_huge_coordinates_end_with_one_line_and_a_report(write, tmp_path):
    text = "v 1e300 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
    report = tmp_path / "report.json"
    done = batch("--input", write("huge.obj", text), "--scale", 1, "--report", report)
    # Blender itself may add a line about the machine, but NumPy none about the number.
    assert done.returncode == 1 and reason(done) and "Warning" not in done.stderr
    assert "NaN" not in report.read_text() and "Infinity" not in report.read_text()


def test_a_machine_is_used_though_the_stored_profile_is_gone(tmp_path):
    bpy.ops.meshknit.add_straight_tube(radius=20.0, length=60.0)
    bpy.context.scene.meshknit.machine_file = str(tmp_path / "gone.json")
    scene = tmp_path / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(scene))
    done = batch("--until", "check", scene=scene)
    assert done.returncode == 2 and "gone.json" in reason(done)
    done = batch("--until", "check", "--machine", "shima_swg091n2", scene=scene)
    assert done.returncode == 0, done.stderr


def test_the_line_names_marks_and_options(tube, write):
    twice = write("twice.json", NO_KNIT["contradictory times"][1])
    line = reason(batch("--input", tube, "--scale", 1, "--marks", twice))
    assert "times[2] (0.5)" in line
    line = reason(batch("--input", tube, "--marks", write("m.json", TUBE_MARKS)))
    assert "--scale" in line  # read as metres


def test_the_report_is_written_though_another_output_is_not(tmp_path):
    options = SimpleNamespace(graph=None, stitches=None, output=str(tmp_path / ("x" * 300)))
    options.report, options.kcode = str(tmp_path / "report.json"), None
    files = SimpleNamespace(text="", kcode="", sheet="")
    outcome = SimpleNamespace(results={"emit": SimpleNamespace(value=files)})
    with pytest.raises(headless.UsageError, match="xxx"):
        headless.write_files(options, outcome, {"ok": True})
    assert json.loads((tmp_path / "report.json").read_text()) == {"ok": True}


@pytest.mark.parametrize("quiet", [True, False])
def test_progress_is_told_unless_quiet(quiet, monkeypatch, capsys):
    monkeypatch.setattr(headless, "SECONDS_BETWEEN_LINES", 0.01)
    library = SimpleNamespace(RunContext=lambda: SimpleNamespace(progress=0.25))
    with headless._progress(library, quiet):
        time.sleep(0.2)
    assert ("meshknit: 25%" in capsys.readouterr().err) != quiet


def test_help_is_no_error():
    command = [bpy.app.binary_path, "--background", "--factory-startup", "--python", str(BATCH)]
    done = subprocess.run([*command, "--", "--help"], capture_output=True, text=True)
    assert done.returncode == 0 and "--stitch-width" in done.stdout


def test_the_demo_leaves_its_files_and_a_summary(tmp_path):
    demo = str(BATCH.with_name("demo.py"))
    command = [bpy.app.binary_path, "--background", "--factory-startup", "--python", demo]
    done = subprocess.run(
        [*command, "--", str(tmp_path / "demo"), "--no-picture"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    left = {path.name for path in (tmp_path / "demo").iterdir()}
    assert left == {
        f"sock.{end}"
        for end in ("blend", "k", "k.txt", "report.json", "graph.json", "stitches.json")
    }
    for word in ("stitches", "short", "passes", "needles", "minutes", "passed", "seconds"):
        assert word in done.stdout
    report = json.loads((tmp_path / "demo" / "sock.report.json").read_text())
    kinds = {
        s["kind"]
        for s in json.loads((tmp_path / "demo" / "sock.stitches.json").read_text())["stitches"]
    }
    # The sock shows all that a single tube can have.
    assert report["graph"]["short_rows"] > 10
    assert kinds == {"start", "knit", "increase", "decrease", "tuck", "end"}


def test_auto_opens_a_closed_ball_by_itself(write, tmp_path):
    ball = write("ball.obj", meshes.obj_text(*meshes.ball()))
    out, report = tmp_path / "ball.k", tmp_path / "ball.json"
    done = batch("--input", ball, "--scale", 1, "--auto", "--output", out, "--report", report)
    assert done.returncode == 0, done.stderr
    told = json.loads(report.read_text())
    assert told["check"]["ok"] and out.read_text().startswith(";!knitout")
    chosen = told["suggested"]["suggestions"][told["suggested"]["chosen"]]
    # What was chosen is a marks file: with it the same is knit again.
    marks, again = write("marks.json", chosen), tmp_path / "again.k"
    done = batch("--input", ball, "--scale", 1, "--marks", marks, "--output", again)
    assert done.returncode == 0, done.stderr
    assert again.read_text() == out.read_text()


def test_auto_says_why_nothing_can_be_suggested(write, tmp_path):
    ball = write("ball.obj", meshes.obj_text(*meshes.ball(radius=6.0)))
    done = batch("--input", ball, "--scale", 1, "--auto", "--report", tmp_path / "r.json")
    assert done.returncode == 1
    assert "finer stitches" in reason(done)
    assert json.loads((tmp_path / "r.json").read_text())["problems"]
