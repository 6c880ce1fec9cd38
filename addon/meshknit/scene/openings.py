"""Openings of a mesh: a list of names, places and times, and a face attribute that says which faces
are left out. The mesh itself stays whole. All of this needs Object Mode."""

import numpy as np

from .. import names
from .attributes import read_attribute, write_attribute


def opening_numbers(mesh):
    """One number per face: 0, or the number of its opening."""
    numbers = read_attribute(mesh, names.OPENING, "INT", "FACE")
    return np.zeros(len(mesh.polygons), np.int32) if numbers is None else numbers


def add_opening(mesh, location, radius, time=None, name=None):
    """An opening round a place; lengths in the object's own space and units. Without a time its rim
    needs one from elsewhere. -> its index in the list"""
    entry = _new_entry(mesh, time, name)
    entry.location, entry.radius = location, radius
    return getattr(mesh, names.PROPERTIES).active_opening


def add_face_opening(mesh, faces, time=None, name=None):
    """Leaves faces out. Those that another opening had go over to this one. -> its index"""
    numbers = opening_numbers(mesh)
    openings = getattr(mesh, names.PROPERTIES).openings
    number = 1 + max([0, int(numbers.max(initial=0)), *(o.number for o in openings)])
    numbers[np.asarray(faces, dtype=int)] = number
    write_attribute(mesh, names.OPENING, "INT", "FACE", numbers)
    _new_entry(mesh, time, name).number = number
    return getattr(mesh, names.PROPERTIES).active_opening


def store_openings(mesh, openings):
    """Adds openings given as (location, radius, time or None), in the object's own space and units."""
    for location, radius, time in openings:
        add_opening(mesh, location, radius, time)
    getattr(mesh, names.PROPERTIES).active_opening = 0


def remove_opening(mesh, index):
    """Its faces are part of the surface again."""
    settings = getattr(mesh, names.PROPERTIES)
    number = settings.openings[index].number
    if number:
        numbers = opening_numbers(mesh)
        numbers[numbers == number] = 0
        write_attribute(mesh, names.OPENING, "INT", "FACE", numbers)
    settings.openings.remove(index)
    settings.active_opening = max(0, min(settings.active_opening, len(settings.openings) - 1))


def faces_of_opening(mesh, index):
    number = getattr(mesh, names.PROPERTIES).openings[index].number
    return np.flatnonzero(opening_numbers(mesh) == number) if number else np.empty(0, int)


def selected_faces(mesh):
    chosen = np.empty(len(mesh.polygons), bool)
    mesh.polygons.foreach_get("select", chosen)
    return np.flatnonzero(chosen)


def _new_entry(mesh, time, name):
    settings = getattr(mesh, names.PROPERTIES)
    entry = settings.openings.add()
    settings.active_opening = len(settings.openings) - 1
    entry.name = name or f"Opening {len(settings.openings)}"
    entry.has_time = time is not None
    if time is not None:
        entry.time = time
    return entry
