"""Draws the live field. Called while drawing only."""

import bpy
import numpy as np
from mathutils import Matrix

from .batches import cached
from .field_shader import LINE_STRENGTH, LINE_WIDTH, field_shader


def draw_field(field, matrix_world, lift, with_lines):
    """`field`: a shown field; it moves with its object. Lifted towards the viewer by `lift` units."""
    import gpu

    batch = cached("live field", field.revision, lambda: _batch(field))
    shader = field_shader()
    shader.bind()
    moved = matrix_world @ field.matrix.inverted_safe()
    view = gpu.matrix.get_model_view_matrix() @ moved
    lifted = Matrix.Translation((0.0, 0.0, lift)) @ view
    shader.uniform_float("to_screen", gpu.matrix.get_projection_matrix() @ lifted)
    shader.uniform_float("towards_viewer", view.row[2].xyz.normalized())
    shader.uniform_float("lines", LINE_STRENGTH if with_lines else 0.0)
    shader.uniform_float("stale", 1.0 if field.stale else 0.0)
    pixel = bpy.context.preferences.system.pixel_size
    shader.uniform_float("line_width", LINE_WIDTH * pixel)
    batch.draw(shader)


def _batch(field):
    """Places and triangles stay on the GPU; a change sends times and rows only."""
    import gpu

    places, triangles = cached("live shape", field.live.shape.serial, lambda: _shape(field))
    values = gpu.types.GPUVertBuf(_format(("time", 1), ("row", 1)), len(field.times))
    values.attr_fill("time", np.ascontiguousarray(field.times, np.float32))
    values.attr_fill("row", np.ascontiguousarray(field.rows, np.float32))
    batch = gpu.types.GPUBatch(type="TRIS", buf=places, elem=triangles)
    batch.vertbuf_add(values)
    return batch


def _shape(field):
    import gpu

    shape = field.live.shape
    places = gpu.types.GPUVertBuf(_format(("pos", 3)), len(shape.places))
    places.attr_fill("pos", shape.places)
    return places, gpu.types.GPUIndexBuf(type="TRIS", seq=shape.faces)


def _format(*attributes):
    import gpu

    made = gpu.types.GPUVertFormat()
    for name, width in attributes:
        made.attr_add(id=name, comp_type="F32", len=width, fetch_mode="FLOAT")
    return made
