"""What a run depends on besides the model."""

from dataclasses import dataclass, field

from .machines import Machine


@dataclass(frozen=True)
class Settings:
    """Field names and defaults are those of the native options. Lengths in mm."""

    stitch_width: float = 3.66  # l_r
    stitch_height: float = 1.73  # l_c
    relax: bool = True  # even edges out afterwards
    machine: Machine = field(default_factory=Machine)
    allow_seams: bool = False  # cut tubes that would have to cross, to be sewn
