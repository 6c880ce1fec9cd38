"""Shortest paths along a mesh's own edges, from Python."""

import numpy as np
import pytest

from meshknit import native

library = native.load()
# A square with a fifth vertex that hangs on its corner 2, and one that hangs on nothing.
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 1, 0], [9, 9, 9]], float)
SIDES = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [2, 4]])


def test_paths_and_their_edges_are_rows_of_the_arrays():
    graph = library.EdgeGraph(CORNERS, SIDES)
    assert graph.path(0, 4) == [0, 1, 2, 4]
    assert graph.edges_along([0, 1, 2, 4]) == [0, 1, 4]
    assert graph.path(0, 5) == []


def test_what_is_not_there_is_an_error():
    with pytest.raises(library.InvalidInput, match="no vertex 9"):
        library.EdgeGraph(CORNERS, SIDES).path(0, 9)
    with pytest.raises(library.InvalidInput, match="shape"):
        library.EdgeGraph(CORNERS, SIDES.ravel())
