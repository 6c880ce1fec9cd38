"""The options of a headless run, and the machine profiles they name."""

import json

import pytest

from meshknit.core.batch_options import parse_options
from meshknit.core.errors import UsageError
from meshknit.core.files import write_whole
from meshknit.core.machines import Machine, make_profile, read_machine
from meshknit import names, native


@pytest.mark.parametrize(
    "arguments, reason",
    [
        (["--auto"], "not supported yet"),
        (["--kcode", "x.kc"], "not supported yet"),
        (["--scale", "0"], "above 0"),
        (["--size", "-3"], "above 0"),
        (["--scale", "nan"], "above 0"),
        (["--scale", "1", "--size", "2"], "not both"),
        (["--input", "x.fbx"], "must be one of"),
        (["--until", "knit"], "until"),
        (["--colour"], "colour"),
        (["--until", "time", "--graph", "g.json"], "needs the stage graph"),
        (["--output", "/no/such/folder/x.k"], "does not exist"),
    ],
)
def test_wrong_options_are_refused(arguments, reason):
    with pytest.raises(UsageError, match=reason):
        parse_options(arguments)


def test_defaults_run_to_the_end():
    options = parse_options([])
    assert options.until == "emit" and options.machine is None and not options.quiet


def test_a_profile_file_changes_one_machine(tmp_path):
    path = tmp_path / "mine.json"
    path.write_text(
        json.dumps({"based_on": "shima_swg091n2", "needles": 300, "carriers": ["4", "5"]})
    )
    profile = make_profile(native.load(), read_machine(str(path)))
    assert profile.needles == 300 and profile.carriers == ["4", "5"]
    assert profile.max_racking == native.load().machine_profile("shima_swg091n2").max_racking


@pytest.mark.parametrize("text", ["{", "[]", "{}", '{"based_on": "other"}'])
def test_a_wrong_profile_file_is_refused(tmp_path, text):
    (tmp_path / "mine.json").write_text(text)
    with pytest.raises(UsageError, match="mine.json"):
        read_machine(str(tmp_path / "mine.json"))


def test_unknown_and_later_machines_are_refused():
    with pytest.raises(UsageError, match="not supported yet"):
        read_machine("kniterate")
    with pytest.raises(UsageError, match="shima_swg091n2"):
        read_machine("loom")
    with pytest.raises(UsageError, match="wrong type"):
        make_profile(native.load(), Machine(changes=(("needles", "many"),)))


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
