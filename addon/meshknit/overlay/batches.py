"""Batches for the GPU. Called while drawing only."""

import bpy
from mathutils import Matrix

_held = {}  # what -> (signature, batch or batches)


def cached(what, signature, make):
    """What make() gave when the signature was the same last."""
    held = _held.get(what)
    if held is None or held[0] != signature:
        held = _held[what] = (signature, make())
    return held[1]


def forget():
    _held.clear()


def new_batch(kind, content, indices=None, prefix=""):
    """None if there is nothing to draw."""
    import gpu
    from gpu_extras.batch import batch_for_shader

    if not len(content["pos"]):
        return None
    shader = gpu.shader.from_builtin(prefix + "SMOOTH_COLOR")
    return batch_for_shader(shader, kind, content, indices=indices)


def new_thick_lines(lines):
    """From overlay_data.Lines."""
    return new_batch("LINES", {"pos": lines.points, "color": lines.colors}, None, "POLYLINE_")


def thick_shader(width):
    """For thick lines; the width is in pixels of a screen of usual resolution."""
    import gpu

    shader = gpu.shader.from_builtin("POLYLINE_SMOOTH_COLOR")
    region = bpy.context.region
    shader.bind()
    shader.uniform_float("viewportSize", (region.width, region.height))
    shader.uniform_float("lineWidth", width * bpy.context.preferences.system.pixel_size)
    return shader


def draw_batch(batch, lift, matrix=None, shader=None):
    """Moves the drawing towards the viewer by `lift` scene units, so that the surface does not
    hide what lies on it."""
    if batch is None:
        return
    import gpu

    with gpu.matrix.push_pop():
        view = gpu.matrix.get_model_view_matrix()
        gpu.matrix.load_matrix(Matrix.Translation((0.0, 0.0, lift)) @ view)
        if matrix is not None:
            gpu.matrix.multiply_matrix(matrix)
        batch.draw(shader or gpu.shader.from_builtin("SMOOTH_COLOR"))
