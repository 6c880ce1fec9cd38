"""A chain that is drawn stop by stop, on a cloth of 6 x 6 squares; vertex (column, row) is
row * 7 + column."""

import numpy as np
import pytest

from meshknit import native
from meshknit.core.chain_drawing import ChainDrawing
from meshknit.core.typed_number import TypedNumber


@pytest.fixture
def cloth():
    places = np.array([(c, r, 0.0) for r in range(7) for c in range(7)])
    edges = [(r * 7 + c, r * 7 + c + 1) for r in range(7) for c in range(6)]
    edges += [(r * 7 + c, r * 7 + c + 7) for r in range(6) for c in range(7)]
    return native.load().EdgeGraph(places, np.array(edges))


def test_the_chain_leads_through_the_stops_in_order(cloth):
    drawing = ChainDrawing(cloth, [0])
    assert drawing.extend_to(3) and drawing.extend_to(24)
    assert drawing.chain == [0, 1, 2, 3, 10, 17, 24]
    assert drawing.edge_count == 6 and not drawing.closed


def test_going_back_shortens_it(cloth):
    drawing = ChainDrawing(cloth, [0])
    drawing.extend_to(5)
    drawing.extend_to(2)
    assert drawing.chain == [0, 1, 2]
    drawing.extend_to(0)
    assert drawing.chain == [0] and drawing.edge_count == 0


def test_coming_to_the_beginning_closes_it_and_overshooting_keeps_it_closed(cloth):
    drawing = ChainDrawing(cloth, [0])
    for stop in (2, 16, 14):
        drawing.extend_to(stop)
    drawing.extend_to(0)
    assert drawing.closed and drawing.edge_count == 8
    assert drawing.vertices() == [0, 1, 2, 9, 16, 15, 14, 7, 0]
    assert not drawing.extend_to(0)
    drawing.extend_to(1)  # a little too far, over the chain's own beginning
    assert drawing.closed and drawing.edge_count == 8


def test_a_loop_that_is_left_again_opens(cloth):
    drawing = ChainDrawing(cloth, [0])
    for stop in (2, 16, 14, 0):
        drawing.extend_to(stop)
    drawing.extend_to(35)
    assert not drawing.closed and drawing.chain[-1] == 35


def test_crossing_itself_drops_the_knot(cloth):
    drawing = ChainDrawing(cloth, [0])
    for stop in (3, 17, 15, 1):
        drawing.extend_to(stop)
    assert drawing.chain == [0, 1]


def test_where_nothing_leads_it_stays():
    places = np.array([(0.0, 0, 0), (1, 0, 0), (5, 0, 0)])
    drawing = ChainDrawing(native.load().EdgeGraph(places, np.array([(0, 1)])), [0])
    assert not drawing.extend_to(2) and drawing.chain == [0]


def test_a_number_is_typed_key_by_key():
    typed = TypedNumber()
    assert typed.value is None
    for character in "0.25":
        typed.take(character)
    typed.take(".")  # a second point is left out
    assert typed.value == 0.25
    typed.take("-")
    assert typed.value == -0.25
    typed.take("\b")
    typed.take("-")
    assert typed.text == "0.2"
