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

# Of the knit graph's lines: sRGB and opacity. They must stand out from the field.
ROW = (0.10, 0.10, 0.12, 0.60)
COLUMN = (0.10, 0.10, 0.12, 0.30)
SHORT_ROW = (0.05, 0.05, 0.05, 1.00)
INCREASE = (0.00, 0.62, 0.20, 1.00)
DECREASE = (0.93, 0.00, 0.73, 1.00)
RIM = (1.00, 0.45, 0.00, 1.00)
EDGE_OF_MARK = (0.08, 0.08, 0.10, 0.85)  # on both sides of a mark, so that pale ones stand out
SELECTED = (1.00, 1.00, 1.00, 1.00)
STALE = (0.50, 0.50, 0.50, 0.35)


def time_colors(times):
    """(n, 4) sRGB colours of times from -1 to 1; grey where a time is unknown (NaN)."""
    times = np.asarray(times, dtype=np.float64)
    at = (np.clip(np.nan_to_num(times), -1.0, 1.0) + 1.0) * 0.5 * (len(_STOPS) - 1)
    stops = np.arange(len(_STOPS))
    colors = np.ones((len(times), 4), dtype=np.float32)
    for channel in range(3):
        colors[:, channel] = np.interp(at, stops, _STOPS[:, channel])
    colors[np.isnan(times), :3] = UNKNOWN
    return colors


def to_linear(colors):
    """(n, 4) sRGB -> linear, as Blender keeps colours in attributes and materials."""
    linear = np.array(colors, dtype=np.float32)
    rgb = linear[:, :3]
    linear[:, :3] = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return linear
