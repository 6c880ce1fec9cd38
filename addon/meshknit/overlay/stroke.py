"""What a person is drawing right now. Plain values: operators set them, the overlay draws them."""

from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass(frozen=True)
class Stroke:
    points: np.ndarray  # (n, 3), world space
    time: Optional[float]  # gives the colour; None for the rim of an opening


_shown = None


def show(stroke):
    global _shown
    _shown = stroke


def shown():
    """The Stroke or None."""
    return _shown


def clear():
    show(None)
