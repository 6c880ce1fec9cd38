"""The Kniterate: its own file, which a reader of these tests knits beside the knitout file, and the run
sheet."""

import json

import bpy
import pytest

import kcode
import meshes
from test_batch import TUBE_MARKS, batch, reason, tube, tube_marks, write


def test_a_kcode_file_makes_the_loops_of_the_knitout_file(tube, tube_marks, tmp_path):
    knitout, own, report = (tmp_path / name for name in ("out.k", "out.kc", "report.json"))
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks, "--machine", "kniterate",
        "--output", knitout, "--kcode", own, "--report", report,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    told = json.loads(report.read_text())
    loops = kcode.knit_side_by_side(own.read_text(), knitout.read_text())
    assert loops > told["check"]["loops"]  # waste, too
    # Draw thread, yarn, waste; no racking beyond 2; no needle beyond 252.
    program = told["program"]
    assert program["carriers"] == ["1", "2", "6"]
    assert program["max_racking"] <= 2 and 1 <= program["needles"][0] < program["needles"][1] <= 252


def test_a_damaged_kcode_file_is_noticed(tube, tube_marks, tmp_path):
    knitout, own = tmp_path / "out.k", tmp_path / "out.kc"
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks, "--machine", "kniterate",
        "--output", knitout, "--kcode", own,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    lines = own.read_text().splitlines()
    at = [i for i, line in enumerate(lines) if line.startswith("FRNT:") and "-" in line][9]
    lines[at] = lines[at].replace("-", "_", 1)
    with pytest.raises(AssertionError):
        kcode.knit_side_by_side("\n".join(lines), knitout.read_text())


def test_run_sheets_stand_beside_their_files(tube, tube_marks, tmp_path):
    knitout, own, report = (tmp_path / name for name in ("out.k", "out.kc", "report.json"))
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks, "--machine", "kniterate",
        "--output", knitout, "--kcode", own, "--report", report,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    sheet = (tmp_path / "out.k.txt").read_text()
    assert sheet == (tmp_path / "out.kc.txt").read_text()
    program = json.loads(report.read_text())["program"]
    low, high = program["needles"]
    for words in (
        "kniterate, 7 needles an inch",
        f"needles {low} to {high}",
        f"about {round(program['estimated_minutes'])} minutes",
        "1   draw thread",
        "2   yarn of the object, for part 1",
        "6   waste",
        "pull the draw thread",
        "weave in 2 ends",
    ):
        assert words in sheet, words
    assert "  3   empty" in sheet


def test_the_shima_gets_a_run_sheet_but_no_kcode(tube, tube_marks, tmp_path):
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks, "--kcode", tmp_path / "out.kc"
    )
    assert done.returncode == 2 and "--machine kniterate" in reason(done)
    done = batch(
        "--input", tube, "--scale", 1, "--marks", tube_marks, "--output", tmp_path / "out.k"
    )
    assert done.returncode == 0 and "shima_swg091n2" in (tmp_path / "out.k.txt").read_text()
    assert not (tmp_path / "out.kc").exists()


def test_an_object_that_does_not_fit_says_how_large_it_may_be(write, tmp_path):
    wide = write("wide.obj", meshes.obj_text(*meshes.tube(radius=200.0)))
    marks = write("marks.json", TUBE_MARKS)
    done = batch("--input", wide, "--scale", 1, "--marks", marks, "--machine", "kniterate")
    assert done.returncode == 1 and "%" in reason(done)


def test_the_panel_writes_all_that_a_kniterate_needs(tmp_path):
    bpy.ops.meshknit.add_straight_tube(radius=20.0, length=60.0)
    bpy.context.scene.meshknit.machine = "kniterate"
    assert bpy.ops.meshknit.write_knitout(output=str(tmp_path / "tube.k")) == {"FINISHED"}
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["tube.k", "tube.k.txt", "tube.kc", "tube.kc.txt"]
    text = (tmp_path / "tube.k").read_text()
    assert ";;Machine: Kniterate" in text and "inhook" not in text
    assert kcode.knit_side_by_side((tmp_path / "tube.kc").read_text(), text) > 0


def test_only_the_kniterate_gets_its_own_files_from_scripts(tmp_path):
    bpy.ops.meshknit.add_straight_tube(radius=20.0, length=60.0)
    with pytest.raises(RuntimeError, match="Kniterate"):
        bpy.ops.meshknit.write_knitout(
            output=str(tmp_path / "tube.k"), kcode=str(tmp_path / "tube.kc")
        )
    assert list(tmp_path.iterdir()) == []
