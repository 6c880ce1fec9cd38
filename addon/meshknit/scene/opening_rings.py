"""Round openings as rings on the surface: a guess of what will be cut."""

import math

import bmesh
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from .mark_lists import OPENINGS
from .read_model import mean_scale

SIDES = 64


def surface_of(ob, depsgraph):
    """The surface as shown, in the object's own space."""
    if ob.mode == "EDIT":
        return BVHTree.FromBMesh(bmesh.from_edit_mesh(ob.data))
    return BVHTree.FromObject(ob, depsgraph)


def ring_on_surface(surface, matrix, place, radius):
    """-> (SIDES, 3) places in world space at about `radius` from `place`, all in world space; None
    where there is no surface. Requires: `matrix`, the object's, has an inverse."""
    to_local = matrix.inverted_safe()
    centre, normal, _, _ = surface.find_nearest(to_local @ Vector(place))
    if centre is None:
        return None
    normal = (to_local.to_3x3().transposed() @ normal).normalized()
    aside = normal.orthogonal().normalized()
    ahead = normal.cross(aside)
    centre = matrix @ centre
    ring = []
    for side in range(SIDES):
        turn = 2.0 * math.pi * side / SIDES
        toward = math.cos(turn) * aside + math.sin(turn) * ahead
        ring.append(_walk(surface, matrix, to_local, centre, toward, radius))
    return np.array(ring)


def _walk(surface, matrix, to_local, place, toward, length, steps=6):
    """Where a walk along the surface ends that begins in a direction."""
    for _ in range(steps):
        near, _, _, _ = surface.find_nearest(to_local @ (place + toward * (length / steps)))
        onward = matrix @ near
        if (onward - place).length > 0.0:
            toward = (onward - place).normalized()
        place = onward
    return place


def world_rings(ob, surface):
    """-> [(index of the opening, ring)] of all round ones."""
    longer = mean_scale(ob.matrix_world)
    found = []
    for index, entry in enumerate(OPENINGS.entries(ob.data)):
        if entry.number == 0:
            place = ob.matrix_world @ entry.location
            ring = ring_on_surface(surface, ob.matrix_world, place, entry.radius * longer)
            if ring is not None:
                found.append((index, ring))
    return found
