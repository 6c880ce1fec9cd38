"""Openings at the border between Python and the library."""

import numpy as np
import pytest

from meshknit import native

library = native.load()
# A box of 100 mm, two triangles a side; faces 2 and 3 are the top.
CORNERS = np.array([[x, y, z] for z in (0, 100) for y in (0, 100) for x in (0, 100)], float)
SIDES = np.array(
    [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
     [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
)  # fmt: skip


def test_a_mark_and_marked_faces_go_together():
    numbers = [0] * 12
    numbers[0] = numbers[1] = 4
    cut = library.cut_openings(CORNERS, SIDES, numbers, [((50.0, 40.0, 100.0), 12.0)])
    assert cut.ok and cut.problems == []
    mark, faces = cut.openings
    assert (mark["mark"], mark["faces"], faces["mark"], faces["face_mark"]) == (0, [], -1, 4)
    assert faces["faces"] == [0, 1] and faces["rim_length"] == pytest.approx(400.0)
    assert mark["rim_length"] == pytest.approx(2.0 * np.pi * 12.0, rel=0.01)
    rim = cut.vertices[mark["rim"]]
    away = np.linalg.norm(rim - (50.0, 40.0, 100.0), axis=1)
    np.testing.assert_allclose(away, 12.0, rtol=0.02)
    # Every row leads back.
    kept = cut.source_vertex >= 0
    np.testing.assert_array_equal(cut.vertices[kept], CORNERS[cut.source_vertex[kept]])
    np.testing.assert_array_equal(
        cut.vertex_of_source[cut.source_vertex[kept]], np.flatnonzero(kept)
    )
    assert len(cut.source_face) == len(cut.faces) and not {0, 1} & set(cut.source_face.tolist())
    surface = library.Surface(cut.vertices, cut.faces)
    assert surface.ok and len(surface.boundaries) == 2


def test_what_cannot_be_cut_says_why_and_leaves_the_arrays():
    cut = library.cut_openings(CORNERS, SIDES, [], [((50.0, 40.0, 100.0), 1.0)], stitch_width=5.0)
    assert not cut.ok and cut.openings == []
    assert [p["code"] for p in cut.problems] == ["opening-too-small"]
    np.testing.assert_array_equal(cut.faces, SIDES)


def test_wrong_lengths_are_usage_errors():
    with pytest.raises(library.InvalidInput, match="face mark"):
        library.cut_openings(CORNERS, SIDES, [1, 0], [])
