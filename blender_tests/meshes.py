"""Small meshes with known faults, as (vertices, polygons). Lengths as the caller likes them."""

import math

import numpy as np


def tube(radius=30.0, length=60.0, around=24, along=6):
    """An upright tube of quads, open at both ends, outside out."""
    vertices = [
        (radius * math.cos(a), radius * math.sin(a), length * i / along)
        for i in range(along + 1)
        for a in (2.0 * math.pi * j / around for j in range(around))
    ]
    polygons = []
    for i in range(along):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            polygons.append([a, b, b + around, a + around])
    return np.array(vertices), polygons


def ball(radius=50.0, around=24, along=12):
    """A closed ball of quads, with a fan of triangles round each pole."""
    vertices = [(0.0, 0.0, -radius)]
    for i in range(1, along):
        up = math.pi * i / along
        ring, height = radius * math.sin(up), -radius * math.cos(up)
        turns = (2.0 * math.pi * j / around for j in range(around))
        vertices += [(ring * math.cos(a), ring * math.sin(a), height) for a in turns]
    vertices.append((0.0, 0.0, radius))
    top, polygons = len(vertices) - 1, []
    for j in range(around):
        k = (j + 1) % around
        polygons.append([0, 1 + k, 1 + j])
        for i in range(along - 2):
            a, b = 1 + i * around + j, 1 + i * around + k
            polygons.append([a, b, b + around, a + around])
        polygons.append([top - around + j, top - around + k, top])
    return np.array(vertices), polygons


def disk(radius=40.0, around=24):
    """One boundary only."""
    vertices, polygons = tube(radius, 0.0, around, 1)
    vertices[around:, :2] *= 0.5
    return vertices, polygons + [list(range(around, 2 * around))[::-1][::-1]]


def moebius(radius=60.0, width=40.0, around=40):
    """A band with half a twist: one side, one boundary."""
    vertices, polygons = [], []
    for j in range(around):
        angle = 2.0 * math.pi * j / around
        for side in (-0.5, 0.5):
            out = radius + side * width * math.cos(angle / 2.0)
            up = side * width * math.sin(angle / 2.0)
            vertices.append((out * math.cos(angle), out * math.sin(angle), up))
    for j in range(around):
        a, b = 2 * j, 2 * j + 1
        c, d = (2 * j + 2, 2 * j + 3) if j + 1 < around else (1, 0)
        polygons.append([a, c, d, b])
    return np.array(vertices), polygons


def hourglass(radius=40.0, height=60.0, around=24):
    """Two open cones that share their tip: not a surface at that vertex."""
    ring = [
        (radius * math.cos(a), radius * math.sin(a))
        for a in np.arange(around) * 2 * math.pi / around
    ]
    vertices = [(0.0, 0.0, 0.0)]
    vertices += [(x, y, height) for x, y in ring] + [(x, y, -height) for x, y in ring]
    polygons = []
    for j in range(around):
        k = (j + 1) % around
        polygons.append([0, 1 + j, 1 + k])
        polygons.append([0, 1 + around + k, 1 + around + j])
    return np.array(vertices), polygons


def obj_text(vertices, polygons):
    lines = ["v %.9g %.9g %.9g" % tuple(v) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in p) for p in polygons]
    return "\n".join(lines) + "\n"


def marks(*times, units="model"):
    """A marks file: (time, point near a boundary) for each boundary."""
    entries = [{"time": time, "boundary_near": list(point)} for time, point in times]
    return {"format": "meshknit-marks-1", "units": units, "times": entries}


def lantern(size=20.0, along=4):
    """A trunk that parts left and right and then front and back; both fronts meet, and both backs,
    and then these: on two beds some tubes would have to cross. Open below and above, of cubes of this
    size with `along` quads along an edge."""
    sides, wide = (0, 4), range(5)
    cubes = {(2, 2, z) for z in (0, 1, 10, 11)}
    cubes |= {(x, 2, 2) for x in wide} | {(x, 2, 3) for x in sides}
    cubes |= {(x, y, 4) for x in sides for y in wide}
    cubes |= {(x, y, z) for x in sides for y in sides for z in (5, 6)}
    cubes |= {(x, y, 7) for x in wide for y in sides}
    cubes |= {(2, y, 8) for y in sides} | {(2, y, 9) for y in wide}
    rims = {((2, 2, 0), (0, 0, -1)), ((2, 2, 11), (0, 0, 1))}
    number, polygons = {}, []
    for cube in sorted(cubes):
        for axis in range(3):
            for way in (-1, 1):
                out = tuple(way * (axis == k) for k in range(3))
                if tuple(np.add(cube, out)) in cubes or (cube, out) in rims:
                    continue
                corner = along * (np.array(cube) + np.maximum(out, 0))
                u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]][::way]
                for i in range(along):
                    for j in range(along):
                        quad = [corner + a * u + b * v for a, b in _square(i, j)]
                        polygons.append([number.setdefault(tuple(p), len(number)) for p in quad])
    return np.array(list(number), dtype=float) * size / along, polygons


def _square(i, j):
    return ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
