"""A picture of a model with its time colours and its knit graph, rendered by Cycles on the CPU."""

import math
import os
import sys
from contextlib import contextmanager

import bpy
import numpy as np
from mathutils import Vector

from . import names
from .core.colors import time_colors, to_linear
from .overlay.overlay_data import graph_edges
from .scene.attributes import write_attribute
from .scene.shapes import add_object, make_mesh

RESOLUTION = (1400, 1000)
SAMPLES = 28
SIDES = 6  # of a tube
# Kind of edge -> (what the legend says, radius in stitch widths, sRGB colour).
TUBES = {
    "column": ("Columns", 0.040, (0.98, 0.97, 0.95)),
    "row": ("Rows", 0.075, (0.98, 0.97, 0.95)),
    "short row": ("Short rows", 0.135, (0.06, 0.06, 0.08)),
    "increase": ("Increases", 0.19, (0.00, 0.60, 0.33)),
    "decrease": ("Decreases", 0.19, (0.86, 0.08, 0.60)),
}
SHINING = "ShaderNodeEmission"
PAPER = (0.84, 0.835, 0.82)
INK = (0.16, 0.16, 0.18)
TURN = math.radians(28.0)  # of the camera round the model, from its side
RISE = math.radians(17.0)  # of the camera above the horizon


def render(context, model, outcome, path):
    """Replaces the scene's objects by those of the picture. `outcome` is a run of the model up to
    `graph` at least."""
    for ob in list(context.scene.objects):
        bpy.data.objects.remove(ob)
    graph = outcome.results["graph"].value
    # The picture is one unit a decimetre: Cycles is at its best near 1.
    unit = 100.0
    vertices, faces = outcome.results["check"].value.arrays(model)
    _add_surface(context, vertices / unit, faces, outcome.results["time"].value[0])
    places = graph.nodes[:, :3] / unit
    for kind, pairs in graph_edges(graph).items():
        if len(pairs):
            _, radius, color = TUBES[kind]
            vertices, polygons = tubes(places[pairs], radius * graph.stitch_width / unit)
            _add_mesh(context, kind, vertices, polygons, _material(kind, color))
    camera = _add_camera(context, places)
    _add_floor(context, places)
    _add_lights(context, places)
    _add_legend(context, camera)
    _set_up_render(context, path)
    with _silent_renderer():
        bpy.ops.render.render(write_still=True)


@contextmanager
def _silent_renderer():
    """Cycles prints a line for every sample, past Python's own standard output."""
    sys.stdout.flush()
    terminal = os.dup(1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        os.dup2(terminal, 1)
        os.close(nowhere)
        os.close(terminal)


def tubes(segments, radius):
    """(n, 2, 3) segments -> vertices and quads of one thin prism round each."""
    along = segments[:, 1] - segments[:, 0]
    along = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    helper = np.where(np.abs(along[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    side = np.cross(along, helper)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(along, side)
    angles = 2.0 * np.pi * np.arange(SIDES) / SIDES
    ring = radius * (
        np.cos(angles)[:, None] * side[:, None, :] + np.sin(angles)[:, None] * up[:, None, :]
    )
    vertices = (segments[:, :, None, :] + ring[:, None]).reshape(-1, 3)
    first = np.arange(SIDES)
    second = (first + 1) % SIDES
    quads = np.stack([first, second, second + SIDES, first + SIDES], axis=1)
    starts = 2 * SIDES * np.arange(len(segments))
    return vertices, (starts[:, None, None] + quads[None]).reshape(-1, 4)


def _add_surface(context, vertices, faces, times):
    material = _material("Time", (0.8, 0.8, 0.8))
    tree = material.node_tree
    color = tree.nodes.new("ShaderNodeAttribute")
    color.attribute_name = names.TIME_COLOR
    tree.links.new(color.outputs["Color"], tree.nodes["Diffuse BSDF"].inputs["Color"])
    ob = _add_mesh(context, "Surface", vertices, faces, material)
    colors = to_linear(time_colors(times))
    write_attribute(ob.data, names.TIME_COLOR, "FLOAT_COLOR", "POINT", colors)


def _add_mesh(context, name, vertices, polygons, material):
    mesh = make_mesh(name, vertices, list(polygons))
    mesh.polygons.foreach_set("use_smooth", np.ones(len(mesh.polygons), bool))
    mesh.materials.append(material)
    return add_object(context, mesh)


def _material(name, color, shader="ShaderNodeBsdfDiffuse"):
    """A material of one sRGB colour: matt, or shining by itself with ShaderNodeEmission."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    node = tree.nodes.new(shader)
    node.inputs["Color"].default_value = to_linear(np.array([[*color, 1.0]]))[0]
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material


def _add_camera(context, places):
    low, high = places.min(axis=0), places.max(axis=0)
    centre = Vector((low + high) / 2.0)
    data = bpy.data.cameras.new("Camera")
    data.lens = 85.0
    camera = bpy.data.objects.new("Camera", data)
    context.collection.objects.link(camera)
    back = Vector(
        (math.sin(TURN) * math.cos(RISE), -math.cos(TURN) * math.cos(RISE), math.sin(RISE))
    )
    camera.rotation_euler = (-back).to_track_quat("-Z", "Y").to_euler()
    half = 0.5 * float(np.linalg.norm(high - low))
    distance = 0.66 * half / math.tan(0.5 * data.angle_y * RESOLUTION[1] / RESOLUTION[0])
    side = camera.rotation_euler.to_quaternion() @ Vector((1.0, 0.0, 0.0))
    # The model stands a little right of the middle: the legend is on the left.
    camera.location = centre + back * distance - side * 0.20 * half
    context.scene.camera = camera
    return camera


def _add_floor(context, places):
    z, size = float(places[:, 2].min()) - 0.01, 60.0
    corners = [(-size, -size, z), (size, -size, z), (size, size, z), (-size, size, z)]
    _add_mesh(context, "Floor", np.array(corners), [[0, 1, 2, 3]], _material("Paper", PAPER))


def _add_lights(context, places):
    centre = Vector((places.min(axis=0) + places.max(axis=0)) / 2.0)
    for name, place, size, power in (
        ("Key", (-3.0, -5.0, 6.0), 4.0, 380.0),
        ("Fill", (7.0, -4.0, 2.5), 5.0, 100.0),
        ("Rim", (2.0, 6.0, 4.0), 3.0, 170.0),
    ):
        data = bpy.data.lights.new(name, "AREA")
        data.size, data.energy = size, power
        light = bpy.data.objects.new(name, data)
        light.location = centre + Vector(place)
        light.rotation_euler = (-Vector(place)).to_track_quat("-Z", "Y").to_euler()
        context.collection.objects.link(light)
    world = bpy.data.worlds.new("World")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = to_linear(np.array([[*PAPER, 1.0]]))[0]
    background.inputs["Strength"].default_value = 0.70
    context.scene.world = world


def _set_up_render(context, path):
    scene = context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = False  # not every build of Blender has a denoiser
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.adaptive_threshold = 0.03
    scene.cycles.max_bounces = 2
    scene.cycles.seed = 0
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = RESOLUTION
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(path.absolute())


def _add_legend(context, camera):
    """Words and a colour bar in front of the camera, at its left edge. One unit is one per cent of
    the picture's width."""
    legend = bpy.data.objects.new("Legend", None)
    context.collection.objects.link(legend)
    legend.parent = camera
    distance = 1.0
    width = 2.0 * distance * math.tan(0.5 * camera.data.angle_x)
    height = 100.0 * RESOLUTION[1] / RESOLUTION[0]
    legend.scale = (width / 100.0,) * 3
    legend.location = (-0.5 * width, -0.5 * height * width / 100.0, -distance)
    _add_bar(context, legend)
    _add_text(context, legend, "last", 8.6, 62.6, 1.9)
    _add_text(context, legend, "Time", 5.2, 66.0, 2.3)
    _add_text(context, legend, "first", 8.6, 34.4, 1.9)
    for line, (kind, (text, _, color)) in enumerate(TUBES.items()):
        y = 27.0 - 4.0 * line
        thickness = 0.55 if kind in ("column", "row") else 0.9
        if kind == "column":
            thickness = 0.3
        corners = [(5.2, y), (9.2, y), (9.2, y + thickness), (5.2, y + thickness)]
        _add_flat(context, legend, kind, corners, [[0, 1, 2, 3]], color)
        _add_text(context, legend, text, 10.6, y - 0.45, 1.9)


def _add_bar(context, legend):
    steps = 64
    y = np.linspace(34.0, 64.0, steps + 1)
    times = np.linspace(-1.0, 1.0, steps)
    for low, high, color in zip(y, y[1:], time_colors(times)):
        corners = [(5.2, low), (7.4, low), (7.4, high), (5.2, high)]
        _add_flat(context, legend, "Bar", corners, [[0, 1, 2, 3]], color[:3])


def _add_flat(context, legend, name, corners, polygons, color):
    vertices = np.array([(x, y, 0.0) for x, y in corners])
    ob = _add_mesh(context, name, vertices, polygons, _material(name, color, SHINING))
    ob.parent = legend
    ob.visible_shadow = ob.visible_diffuse = False


def _add_text(context, legend, text, x, y, size):
    data = bpy.data.curves.new(text, "FONT")
    data.body, data.size = text, size
    data.materials.append(_material(text, INK, SHINING))
    ob = bpy.data.objects.new(text, data)
    ob.location, ob.parent = (x, y, 0.0), legend
    ob.visible_shadow = ob.visible_diffuse = False
    context.collection.objects.link(ob)
