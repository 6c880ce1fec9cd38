"""Points and segments near the mouse. The matrices look along -z: x and y become the screen."""

import numpy as np

from meshknit.core.picking import near_segments, to_pixels

SIZE = (200, 100)
FLAT = np.eye(4)
# An eye at the origin: what is twice as far away is half as large.
EYE = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1, 0]])


def test_the_middle_and_the_corner_of_the_screen():
    pixels, before = to_pixels(np.array([(0.0, 0, 0), (1, 1, 0), (-1, -1, 0)]), FLAT, SIZE)
    assert pixels.tolist() == [[100, 50], [200, 100], [0, 0]] and before.all()


def test_far_things_are_small_and_what_is_behind_is_not_seen():
    pixels, before = to_pixels(np.array([(1.0, 0, -1), (1, 0, -2), (1, 0, 1)]), EYE, SIZE)
    assert pixels[:2, 0].tolist() == [200, 150]
    assert before.tolist() == [True, True, False]


def test_segments_come_nearest_first_and_within_reach():
    starts = np.array([(-1.0, 0.2, 0), (-1, 0.04, 0), (-1, 0.9, 0)])  # 10, 2 and 45 pixels up
    ends = starts * (-1, 1, 1)
    near = near_segments(np.array([50.0, 50.0]), starts, ends, FLAT, SIZE, 12)
    assert near == [(1, 0.25), (0, 0.25)]
    # Beside its end a segment is as far as its end.
    assert near_segments(np.array([250.0, 52.0]), starts, ends, FLAT, SIZE, 12) == []


def test_a_segment_that_reaches_behind_the_eye_is_left_out():
    starts, ends = np.array([(0.0, 0, -1)]), np.array([(0.0, 0, 1)])
    assert near_segments(np.array([100.0, 50.0]), starts, ends, EYE, SIZE, 12) == []
    assert near_segments(np.array([100.0, 50.0]), starts[:0], ends[:0], EYE, SIZE, 12) == []
