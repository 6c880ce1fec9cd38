"""Colours that stay apart for colour-blind eyes. sRGB, 0 to 1."""

import numpy as np

# Blue (early) over pale yellow to red (late): ColorBrewer's RdYlBu, reversed.
_STOPS = np.array(
    [
        (0.192, 0.212, 0.584),
        (0.270, 0.459, 0.706),
        (0.455, 0.678, 0.820),
        (0.671, 0.851, 0.914),
        (1.000, 1.000, 0.749),
        (0.996, 0.878, 0.565),
        (0.992, 0.682, 0.380),
        (0.957, 0.427, 0.263),
        (0.647, 0.000, 0.149),
    ]
)
UNKNOWN = (0.5, 0.5, 0.5)

ROW = (0.16, 0.16, 0.18)
COLUMN = (0.45, 0.45, 0.48)
SHORT_ROW = (0.80, 0.10, 0.75)
INCREASE = (0.00, 0.62, 0.30)
DECREASE = (0.00, 0.00, 0.00)
STALE = (0.5, 0.5, 0.5)


def time_colors(times):
    """(n, 4) linear colours of times from -1 to 1; grey where a time is unknown (NaN)."""
    times = np.asarray(times, dtype=np.float64)
    at = (np.clip(np.nan_to_num(times), -1.0, 1.0) + 1.0) * 0.5 * (len(_STOPS) - 1)
    stops = np.arange(len(_STOPS))
    colors = np.ones((len(times), 4), dtype=np.float32)
    for channel in range(3):
        colors[:, channel] = np.interp(at, stops, _STOPS[:, channel])
    colors[np.isnan(times), :3] = UNKNOWN
    colors[:, :3] = to_linear(colors[:, :3])
    return colors


def to_linear(color):
    """sRGB -> linear, as Blender keeps colours."""
    color = np.asarray(color, dtype=np.float64)
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
