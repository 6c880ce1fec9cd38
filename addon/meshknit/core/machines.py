"""Machine profiles: a built-in name, or a file that changes some fields of one."""

import json
import os
from dataclasses import dataclass
from pathlib import Path

from .. import names
from .errors import UsageError

BUILT_IN = tuple(entry[0] for entry in names.MACHINES)


@dataclass(frozen=True)
class Machine:
    """A built-in profile's name and the fields that differ from it."""

    based_on: str = BUILT_IN[0]
    changes: tuple = ()


def read_machine(name):
    """A profile's name or the path of a profile file -> Machine. Throws UsageError."""
    if name in BUILT_IN:
        return Machine(name)
    if not os.path.isfile(name):
        raise UsageError(f"{name} is neither a machine ({', '.join(BUILT_IN)}) nor a profile file")
    try:
        fields = json.loads(Path(name).read_text(encoding="utf-8"))
    except OSError as error:
        raise UsageError(f"cannot read the machine profile {name}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise UsageError(f"the machine profile {name} is not JSON: {error}") from error
    if not isinstance(fields, dict) or fields.get("based_on") not in BUILT_IN:
        raise UsageError(
            f'the machine profile {name} must be an object whose "based_on" is one of: '
            + ", ".join(BUILT_IN)
        )
    based_on = fields.pop("based_on")
    frozen = {key: tuple(v) if isinstance(v, list) else v for key, v in fields.items()}
    return Machine(based_on, tuple(sorted(frozen.items())))


def make_profile(library, machine):
    """The library's profile of a machine. Throws UsageError for a field that it does not have, and
    for a value that no machine has."""
    profile = library.machine_profile(machine.based_on)
    for key, value in machine.changes:
        if key not in _FIELDS:
            raise UsageError(f'a machine profile has no field "{key}"')
        fits, wanted = _FIELDS[key]
        if not fits(value):
            raise UsageError(f'the machine profile\'s field "{key}" must be {wanted}')
        setattr(profile, key, list(value) if isinstance(value, tuple) else value)
    for key in ("waste_carrier", "yarn_carrier"):
        if getattr(profile, key) not in profile.carriers:
            raise UsageError(
                f'the machine profile\'s field "{key}" must be one of the carriers: '
                + ", ".join(profile.carriers)
            )
    if profile.draw_carrier not in ["", *profile.carriers]:
        raise UsageError(
            'the machine profile\'s field "draw_carrier" must be empty or one of the carriers: '
            + ", ".join(profile.carriers)
        )
    if len({profile.waste_carrier, profile.yarn_carrier, profile.draw_carrier}) < 3:
        raise UsageError(
            'the machine profile\'s fields "waste_carrier", "draw_carrier" and "yarn_carrier" '
            "must differ"
        )
    return profile


def _is_whole(value):
    return isinstance(value, int) and not isinstance(value, bool)


def _is_carrier(value):
    """Programs name carriers in lists, before comments: no separator may be in a name."""
    return (
        isinstance(value, str)
        and value.isprintable()
        and value != ""
        and not set(value).intersection(" ,;")
    )


def _is_carrier_list(value):
    return (
        isinstance(value, tuple)
        and len(value) > 0
        and all(map(_is_carrier, value))
        and len(set(value)) == len(value)
    )


def _is_setting(value):
    return (
        isinstance(value, str)
        and value.isprintable()
        and len(value.split(" ")) <= 2
        and (value.startswith("x-") and ";" not in value)
    )


def _whole(low, high):
    return lambda v: _is_whole(v) and low <= v <= high, f"a whole number from {low} to {high}"


def _real(fits, wanted):
    return lambda v: (_is_whole(v) or isinstance(v, float)) and fits(v), wanted


_POSITIVE = _real(lambda v: 0.0 < v <= 1e6, "a number above 0, at most a million")
_LINE = (lambda v: isinstance(v, str) and v.isprintable(), "one line of text")
_YES_OR_NO = (lambda v: isinstance(v, bool), "true or false")
_CARRIER = (_is_carrier, "a carrier's name, without spaces, commas and semicolons")

# Every field of the library's profile: what its value must fulfil, and that in words.
_FIELDS = {
    "name": _LINE,
    "machine_header": _LINE,
    "gauge": _whole(1, 30),
    "needles": _whole(20, 2000),
    "carriers": (
        _is_carrier_list,
        "a list of different names, none empty or with spaces, commas or semicolons",
    ),
    "waste_carrier": _CARRIER,
    "draw_carrier": (
        lambda v: v == "" or _is_carrier(v),
        "empty, or a carrier's name, without spaces, commas and semicolons",
    ),
    "yarn_carrier": _CARRIER,
    "has_inserting_hook": _YES_OR_NO,
    "has_sliders": _YES_OR_NO,
    "first_stitch_leftward": _YES_OR_NO,
    "max_racking": _whole(1, 20),
    "liked_racking": _whole(1, 20),
    "quarter_pitch": _real(lambda v: 0.0 <= v <= 1.0, "a number from 0 to 1"),
    "max_stack": _whole(2, 10),
    "max_stretch": _whole(3, 20),
    "max_float": _whole(3, 60),
    "waste_rounds": _whole(2, 200),
    "take_down_rounds": _whole(0, 400),
    "take_down_width": _whole(0, 200),
    "tucks_beside_knits": _YES_OR_NO,
    "transfers_in_halves": _YES_OR_NO,
    "takes_kcode": _YES_OR_NO,
    "first_settings": (
        lambda v: isinstance(v, tuple) and all(map(_is_setting, v)),
        'a list of extensions like "x-speed-number 300"',
    ),
    "seconds_per_turn": _POSITIVE,
    "needles_per_second": _POSITIVE,
}
