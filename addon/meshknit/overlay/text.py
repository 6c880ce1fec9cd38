"""Text and points in the plane of a 3D view, the text on a plate that keeps it legible. Pixels count from the lower left."""

import bpy
import numpy as np

DARK = (0.10, 0.10, 0.12, 0.80)
LIGHT = (0.95, 0.95, 0.95, 1.00)
SIZE, STEP, FRAME = 12, 17, 6  # pixels at scale 1


def draw_label(x, y, lines, room=None):
    """`lines` from the top; (x, y) is the lower left of the plate, which moves so that it stays
    within `room`, the width and height that there are."""
    import blf

    scale = bpy.context.preferences.system.ui_scale
    blf.size(0, SIZE * scale)
    width = max(blf.dimensions(0, line)[0] for line in lines)
    width, height = width + 2 * FRAME * scale, (len(lines) * STEP + 4) * scale
    if room is not None:
        x, y = max(0, min(x, room[0] - width)), max(0, min(y, room[1] - height))
    draw_plate(x, y, width, height, DARK)
    for row, line in enumerate(reversed(lines)):
        blf.position(0, x + FRAME * scale, y + (6 + row * STEP) * scale, 0)
        blf.color(0, *LIGHT)
        blf.draw(0, line)


def draw_plate(left, bottom, width, height, shade):
    import gpu
    from gpu_extras.batch import batch_for_shader

    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    right, top = left + width, bottom + height
    corners = [(left, bottom, 0), (right, bottom, 0), (right, top, 0), (left, top, 0)]
    batch = batch_for_shader(shader, "TRIS", {"pos": corners}, indices=[(0, 1, 2), (0, 2, 3)])
    gpu.state.blend_set("ALPHA")
    shader.bind()
    shader.uniform_float("color", shade)
    batch.draw(shader)
    gpu.state.blend_set("NONE")


def draw_dot(x, y):
    """A white dot with a dark rim, round a vertex."""
    import gpu
    from gpu_extras.batch import batch_for_shader

    scale = bpy.context.preferences.system.ui_scale
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    gpu.state.blend_set("ALPHA")
    for radius, shade in ((6.5 * scale, DARK), (4.5 * scale, LIGHT)):
        turns = 2.0 * np.pi * np.arange(16) / 16
        rim = np.stack(
            [x + radius * np.cos(turns), y + radius * np.sin(turns), 0.0 * turns], axis=1
        )
        fan = [(0, i, i + 1) for i in range(1, 15)]
        batch = batch_for_shader(shader, "TRIS", {"pos": rim.astype(np.float32)}, indices=fan)
        shader.bind()
        shader.uniform_float("color", shade)
        batch.draw(shader)
    gpu.state.blend_set("NONE")


def draw_lines(pairs):
    """Light lines between pairs of pixels."""
    import gpu
    from gpu_extras.batch import batch_for_shader

    if not pairs:
        return
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    points = np.array([(x, y, 0.0) for pair in pairs for x, y in pair], np.float32)
    batch = batch_for_shader(shader, "LINES", {"pos": points})
    shader.bind()
    shader.uniform_float("color", LIGHT)
    batch.draw(shader)
