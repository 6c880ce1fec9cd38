"""What lies under the mouse in a 3D view."""

from dataclasses import dataclass
from typing import Optional

import bmesh
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector
from mathutils.interpolate import poly_3d_calc

from .. import names
from ..core.picking import near_segments
from .mark_lists import OPENINGS
from .opening_rings import surface_of

REACH = 12  # pixels at scale 1, from a line or a point
SAME_PLACE = 1e-4  # of the distance from the eye, or a quarter of a segment: rounding, not hiding


@dataclass(frozen=True)
class Hit:
    """A place on the object's surface, in world space."""

    place: np.ndarray
    normal: np.ndarray
    face: int
    vertex: Optional[
        int
    ]  # of the object's own mesh, the nearest; None where a modifier made it all


@dataclass(frozen=True)
class Target:
    """What a press of the left button is about."""

    kind: str  # "END" of a constraint's chain, "CONSTRAINT", "OPENING", "SURFACE" or "MODIFIED"
    hit: Hit
    vertex: Optional[int] = None  # where a chain would begin
    index: Optional[int] = None  # of the constraint or opening


class Pointer:
    """The mouse over one region, with an object to point at. Lives as long as one event or one
    drawing: it holds references to Blender's data."""

    def __init__(self, context, ob, canvas, mouse):
        self._scene, self._depsgraph = context.scene, context.view_layer.depsgraph
        self._region, self._view = context.region, context.region_data
        self._ob, self._canvas, self.mouse = ob, canvas, np.asarray(mouse, float)
        self.reach = REACH * context.preferences.system.ui_scale

    def hit(self):
        """The surface under the mouse, or None where there is none or something hides it."""
        start = view3d_utils.region_2d_to_origin_3d(self._region, self._view, self.mouse)
        toward = view3d_utils.region_2d_to_vector_3d(self._region, self._view, self.mouse)
        found, place, normal, face = self._cast(start, toward)
        if not found:
            return None
        vertex = self._nearest_vertex(np.array(place), face)
        return Hit(np.array(place), np.array(normal), face, vertex)

    def target(self):
        """-> Target, or None where the mouse is not on the object."""
        hit = self.hit()
        for vertex, index in self._canvas.ends if hit else ():
            if self.is_near(vertex) and self.is_visible(self._canvas.places[vertex], 0.0):
                return Target("END", hit, vertex, index)
        constraint = self.constraint()
        if constraint is not None:
            return Target("CONSTRAINT", hit, hit and hit.vertex, constraint)
        if hit is None:
            return None
        opening = self.opening(hit)
        if opening is not None:
            return Target("OPENING", hit, hit.vertex, opening)
        return Target("MODIFIED" if hit.vertex is None else "SURFACE", hit, hit.vertex)

    def constraint(self):
        """-> the index of the constraint whose line the mouse is on, or None."""
        canvas = self._canvas
        row = self._visible_segment(canvas.segments[:, 0], canvas.segments[:, 1])
        return None if row is None else int(canvas.segment_marks[row]) - 1

    def rim(self):
        """-> an edge of the boundary that the mouse is on, or None."""
        canvas = self._canvas
        ends = canvas.places[canvas.edges[canvas.rim_edges]]
        row = self._visible_segment(ends[:, 0], ends[:, 1], 1.5 * self.reach)
        return None if row is None else int(canvas.rim_edges[row])

    def opening(self, hit):
        """-> the index of the opening in which a hit lies, or None."""
        for index, entry in enumerate(OPENINGS.entries(self._ob.data)):
            if entry.number == 0:
                to_local = self._ob.matrix_world.inverted_safe()
                if (to_local @ Vector(hit.place) - entry.location).length <= entry.radius:
                    return index
            elif entry.number == self._face_number(hit.face):
                return index
        return None

    def time(self, hit):
        """The field's time at a hit, or None without a field."""
        if self._ob.mode == "EDIT":
            return None
        mesh = self._ob.evaluated_get(self._depsgraph).data
        times = mesh.attributes.get(names.TIME)
        if times is None or (times.data_type, times.domain) != ("FLOAT", "POINT"):
            return None
        corners = mesh.polygons[hit.face].vertices
        places = [self._ob.matrix_world @ mesh.vertices[v].co for v in corners]
        weights = poly_3d_calc(places, Vector(hit.place))
        return sum(w * times.data[v].value for w, v in zip(weights, corners))

    def is_near(self, vertex):
        """True if the mouse is on a vertex of the object's own mesh."""
        pixel = self.pixel(self._canvas.places[vertex])
        return pixel is not None and (pixel - Vector(self.mouse)).length <= self.reach

    def shown_places(self, vertices):
        """-> (n, 3), on the surface as it is shown."""
        places = self._canvas.places[list(vertices)]
        if self._canvas.own or self._ob.mode == "EDIT":
            return places
        surface = self._canvas.surface(lambda: surface_of(self._ob, self._depsgraph))
        matrix, to_local = self._ob.matrix_world, self._ob.matrix_world.inverted_safe()
        near = (surface.find_nearest(to_local @ Vector(place))[0] for place in places)
        return np.array([matrix @ at for at in near])

    def pixel(self, place):
        """-> (x, y), or None behind the eye."""
        return view3d_utils.location_3d_to_region_2d(self._region, self._view, Vector(place))

    def on_plane_through(self, place):
        """The place under the mouse at the depth of another."""
        return np.array(
            view3d_utils.region_2d_to_location_3d(
                self._region, self._view, self.mouse, Vector(place)
            )
        )

    def _cast(self, start, toward, distance=1.70141e38):
        """-> (hit this object, place, normal, face)"""
        found, place, normal, face, ob, matrix = self._scene.ray_cast(
            self._depsgraph, start, toward, distance=distance
        )
        # An instance is the same object somewhere else: marks are laid on the object itself.
        mine = found and ob.original == self._ob and matrix == self._ob.matrix_world
        return mine, place, normal, face

    def _nearest_vertex(self, place, face):
        canvas = self._canvas
        if canvas.own:
            among = self._corners(face)
            away = np.linalg.norm(canvas.places[among] - place, axis=1)
            return int(among[away.argmin()])
        if not len(canvas.places):
            return None
        away = np.linalg.norm(canvas.places - place, axis=1)
        vertex = int(away.argmin())
        return vertex if away[vertex] <= canvas.longest_edge_at(vertex) else None

    def _corners(self, face):
        if self._ob.mode != "EDIT":
            return np.array(self._ob.data.polygons[face].vertices)
        mesh = bmesh.from_edit_mesh(self._ob.data)
        mesh.faces.ensure_lookup_table()
        return np.array([corner.index for corner in mesh.faces[face].verts])

    def _face_number(self, face):
        """Which opening a face that is shown belongs to."""
        if self._ob.mode == "EDIT":
            if not self._canvas.own:
                return 0
            mesh = bmesh.from_edit_mesh(self._ob.data)
            mesh.faces.ensure_lookup_table()
            layer = mesh.faces.layers.int.get(names.OPENING)
            return mesh.faces[face][layer] if layer else 0
        numbers = self._ob.evaluated_get(self._depsgraph).data.attributes.get(names.OPENING)
        if numbers is None or (numbers.data_type, numbers.domain) != ("INT", "FACE"):
            return 0
        return numbers.data[face].value

    def _visible_segment(self, starts, ends, reach=None):
        size = (self._region.width, self._region.height)
        matrix = np.array(self._view.perspective_matrix)
        reach = reach or self.reach
        near = near_segments(self.mouse, starts, ends, matrix, size, reach)
        for row, at in near[:8]:  # more lie over each other only where they are tiny
            place = starts[row] + at * (ends[row] - starts[row])
            if self.is_visible(place, np.linalg.norm(ends[row] - starts[row])):
                return row
        return None

    def is_visible(self, place, length):
        """True if nothing is between the eye and a place on an edge of this length."""
        pixel = self.pixel(place)
        if pixel is None:
            return False
        start = view3d_utils.region_2d_to_origin_3d(self._region, self._view, pixel)
        toward = Vector(place) - start
        short = max(SAME_PLACE * toward.length, 0.25 * length)
        found, *_ = self._scene.ray_cast(
            self._depsgraph, start, toward.normalized(), distance=max(0.0, toward.length - short)
        )
        return not found
