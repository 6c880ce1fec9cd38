"""Where rows will lie, from the time field alone."""

import numpy as np
import pytest

import meshes
from meshknit.core import row_levels
from meshknit.core.row_levels import FieldGeometry


def triangles(polygons):
    return np.array([[p[0], p[i], p[i + 1]] for p in polygons for i in range(1, len(p) - 1)])


def tube(**shape):
    vertices, polygons = meshes.tube(**shape)
    return np.asarray(vertices, float), triangles(polygons)


def test_rows_of_a_tube_are_its_length_by_their_height_however_coarse():
    for along in (1, 6, 40):
        vertices, faces = tube(radius=30.0, length=60.0, around=24, along=along)
        rows = FieldGeometry(vertices, faces).row_numbers(vertices[:, 2] / 30.0 - 1.0, 3.0)
        np.testing.assert_allclose(rows, vertices[:, 2] / 3.0, atol=0.05)


def test_rows_are_evenly_high_where_time_is_not_even():
    vertices, faces = tube(radius=30.0, length=60.0, around=24, along=60)
    height = vertices[:, 2] / 60.0
    rows = FieldGeometry(vertices, faces).row_numbers(height + height**2, 3.0)
    # Time is three times as fast at the end; 60 mm are 20 rows of 3 mm, there too.
    np.testing.assert_allclose(rows, 20.0 * height, atol=0.1)


def test_a_dead_end_does_not_stretch_the_rows_beside_it():
    """Two tubes side by side: through one time rises, in the other it stands still."""
    vertices, faces = tube(radius=30.0, length=60.0, around=24, along=20)
    both = np.concatenate([vertices, vertices + (100.0, 0.0, 0.0)])
    all_faces = np.concatenate([faces, faces + len(vertices)])
    times = np.concatenate([vertices[:, 2] / 30.0 - 1.0, 1e-4 * vertices[:, 2] / 60.0])
    rows = FieldGeometry(both, all_faces).row_numbers(times, 3.0)
    assert rows.max() == pytest.approx(20.0, rel=0.02)


def test_a_bend_has_the_rows_of_its_middle():
    """A quarter of a ring of tube: rows are wedges, and as many as along its middle."""
    vertices, faces = tube(radius=10.0, length=1.0, around=48, along=60)
    angle = 0.5 * np.pi * vertices[:, 2]
    out = 100.0 + vertices[:, 0]
    bent = np.column_stack([out * np.cos(angle), vertices[:, 1], out * np.sin(angle)])
    rows = FieldGeometry(bent, faces).row_numbers(vertices[:, 2], 3.0)
    # A quarter of 2 pi 100 mm in rows of 3 mm.
    assert rows.max() == pytest.approx(0.5 * np.pi * 100.0 / 3.0, rel=0.03)


def test_a_sample_of_a_large_mesh_says_the_same(monkeypatch):
    vertices, faces = tube(radius=30.0, length=60.0, around=60, along=60)
    height = vertices[:, 2] / 60.0
    whole = FieldGeometry(vertices, faces).row_numbers(height**1.5, 3.0)
    monkeypatch.setattr(row_levels, "MOST_FACES", 1000)
    sample = FieldGeometry(vertices, faces).row_numbers(height**1.5, 3.0)
    np.testing.assert_allclose(sample, whole, atol=0.2)


def test_one_time_everywhere_has_no_rows():
    vertices, faces = tube()
    assert not FieldGeometry(vertices, faces).row_numbers(np.zeros(len(vertices)), 3.0).any()
