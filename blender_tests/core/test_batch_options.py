"""The options of a headless run, and the machine profiles they name."""

import json
import os
import stat

import pytest

from meshknit.core.batch_options import parse_options
from meshknit.core.errors import UsageError
from meshknit.core.files import report_text, write_whole
from meshknit.core.machines import Machine, make_profile, read_machine
from meshknit import names, native


@pytest.mark.parametrize(
    "arguments, reason",
    [
        (["--auto", "--marks", "x.json"], "not both"),
        (["--kcode", ""], "--kcode"),
        (["--until", "graph", "--kcode", "x.kc"], "needs the stage emit"),
        (["--output", "x.k", "--kcode", "x.k"], "another option"),
        (["--output", "x.k", "--report", "x.k.txt"], "another option"),
        (["--scale", "0"], "above 0"),
        (["--size", "-3"], "above 0"),
        (["--scale", "nan"], "above 0"),
        (["--scale", "1", "--size", "2"], "not both"),
        (["--input", "x.fbx"], "must be one of"),
        (["--until", "knit"], "until"),
        (["--colour"], "colour"),
        (["--until", "time", "--graph", "g.json"], "needs the stage graph"),
        (["--output", "/no/such/folder/x.k"], "does not exist"),
        (["--output", ""], "--output"),
        (["--marks", ""], "--marks"),
        (["--output", "."], "no file"),
        (["--output", os.devnull], "no file"),
        (["--output", "x.k", "--report", "./x.k"], "another option"),
        (["--marks", "m.json", "--report", "m.json"], "another option"),
    ],
)
def test_wrong_options_are_refused(arguments, reason):
    with pytest.raises(UsageError, match=reason):
        parse_options(arguments)


def test_defaults_run_to_the_end():
    options = parse_options([])
    assert options.until == "emit" and options.machine is None and not options.quiet
    assert not options.no_relax and parse_options(["--no-relax"]).no_relax
    assert not options.allow_seams and parse_options(["--allow-seams"]).allow_seams


def test_a_profile_file_changes_one_machine(tmp_path):
    path = tmp_path / "mine.json"
    fields = {"needles": 300, "carriers": ["4", "5"], "waste_carrier": "5", "yarn_carrier": "4"}
    path.write_text(json.dumps({"based_on": "shima_swg091n2", **fields}))
    profile = make_profile(native.load(), read_machine(str(path)))
    assert profile.needles == 300 and profile.carriers == ["4", "5"]
    assert profile.max_racking == native.load().machine_profile("shima_swg091n2").max_racking


@pytest.mark.parametrize("text", ["{", "[]", "{}", '{"based_on": "other"}'])
def test_a_wrong_profile_file_is_refused(tmp_path, text):
    (tmp_path / "mine.json").write_text(text)
    with pytest.raises(UsageError, match="mine.json"):
        read_machine(str(tmp_path / "mine.json"))


def test_unknown_machines_are_refused():
    with pytest.raises(UsageError, match="shima_swg091n2"):
        read_machine("loom")
    with pytest.raises(UsageError, match="shima_swg091n2"):
        read_machine("x" * 5000)


@pytest.mark.parametrize(
    "field, value",
    [
        *[("needles", v) for v in ("many", True, 19, 2001, 300.0, None, {}, 10**400)],
        *[("seconds_per_turn", v) for v in (0, -1.0, float("nan"), float("inf"), 10**400, "1")],
        *[("needles_per_second", v) for v in (0.0, float("inf"), False)],
        *[("gauge", v) for v in (0, 31)],
        *[("max_racking", v) for v in (0, 21, 2.5)],
        *[("max_stack", v) for v in (1, 11)],
        *[("max_stretch", v) for v in (2, 21)],
        *[("max_float", v) for v in (2, 61)],
        *[("waste_rounds", v) for v in (1, 201, -5)],
        *[("quarter_pitch", v) for v in (-0.1, 1.1, float("nan"))],
        *[("carriers", v) for v in ((), "12", ("1", "1"), ("1", ""), ("1", "2 3"), ("1", 2))],
        *[("carriers", ("1", "2", v)) for v in ("3,4", "3;", "3\n", ("3",))],
        *[("waste_carrier", v) for v in ("11", 1, "")],
        *[("yarn_carrier", v) for v in ("1", "11")],
        *[("draw_carrier", v) for v in ("11", 1, "1", "2")],
        *[("first_settings", v) for v in ("x-end-pass", ("rack 3",), ("x-a;b",), ("x-a 1\n",))],
        ("has_sliders", 1),
        ("machine_header", "SWG\nknit"),
        ("__class__", 1),
    ],
)
def test_values_that_no_machine_has_are_refused_by_name(field, value):
    with pytest.raises(UsageError, match=f'"{field}"'):
        make_profile(native.load(), Machine(changes=((field, value),)))


def test_every_field_of_the_library_can_be_changed():
    profile = native.load().machine_profile("shima_swg091n2")
    fields = {key: getattr(profile, key) for key in dir(profile) if not key.startswith("_")}
    changes = [(k, tuple(v) if isinstance(v, list) else v) for k, v in fields.items()]
    same = make_profile(native.load(), Machine(changes=tuple(changes)))
    assert {key: getattr(same, key) for key in fields} == fields


def test_machines_are_those_of_the_library():
    assert [entry[0] for entry in names.MACHINES] == native.load().machine_profile_names()


def test_files_are_written_whole_or_not_at_all(tmp_path):
    path = tmp_path / "x.k"
    path.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        write_whole(path, "new \ud800")
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["x.k"]
    write_whole(path, "new")
    assert path.read_text() == "new"
    with pytest.raises(UsageError, match="cannot write"):
        write_whole(tmp_path / "no" / "x.k", "new")


def test_an_existing_file_keeps_its_mode_and_a_link_its_target(tmp_path):
    target, link = tmp_path / "target.k", tmp_path / "link.k"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    write_whole(link, "new")
    assert link.is_symlink() and target.read_text() == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_what_is_no_file_is_not_replaced(tmp_path):
    pipe, loop = tmp_path / "pipe", tmp_path / "loop"
    os.mkfifo(pipe)
    loop.symlink_to(loop)
    for path in (pipe, loop, tmp_path):
        with pytest.raises(UsageError, match="no file"):
            write_whole(path, "new")
    assert stat.S_ISFIFO(pipe.stat().st_mode) and loop.is_symlink()


def test_a_report_is_json_whatever_it_measured():
    text = report_text({"mesh": {"area": float("nan")}, "needles": (1, float("inf"))})
    assert json.loads(text) == {"mesh": {"area": None}, "needles": [1, None]}
