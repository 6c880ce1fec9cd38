"""Machine profiles: a built-in name, or a file that changes some fields of one."""

import json
from dataclasses import dataclass
from pathlib import Path

from .. import names
from .errors import UsageError

BUILT_IN = tuple(entry[0] for entry in names.MACHINES)
NOT_YET = ("kniterate",)


@dataclass(frozen=True)
class Machine:
    """A built-in profile's name and the fields that differ from it."""

    based_on: str = BUILT_IN[0]
    changes: tuple = ()


def read_machine(name):
    """A profile's name or the path of a profile file -> Machine. Throws UsageError."""
    if name in BUILT_IN:
        return Machine(name)
    if name in NOT_YET:
        raise UsageError(f"the machine {name} is not supported yet")
    path = Path(name)
    if not path.is_file():
        raise UsageError(f"{name} is neither a machine ({', '.join(BUILT_IN)}) nor a profile file")
    try:
        fields = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise UsageError(f"cannot read the machine profile {name}: {error}") from error
    if not isinstance(fields, dict) or fields.get("based_on") not in BUILT_IN:
        raise UsageError(
            f'the machine profile {name} must be an object whose "based_on" is one of: '
            + ", ".join(BUILT_IN)
        )
    based_on = fields.pop("based_on")
    frozen = {key: tuple(v) if isinstance(v, list) else v for key, v in fields.items()}
    return Machine(based_on, tuple(sorted(frozen.items())))


def make_profile(library, machine):
    """The library's profile of a machine. Throws UsageError for a field that it does not have."""
    profile = library.machine_profile(machine.based_on)
    for key, value in machine.changes:
        if key.startswith("_") or not hasattr(profile, key):
            raise UsageError(f'a machine profile has no field "{key}"')
        try:
            setattr(profile, key, list(value) if isinstance(value, tuple) else value)
        except TypeError as error:
            raise UsageError(f'the machine profile\'s field "{key}" has the wrong type') from error
    return profile
