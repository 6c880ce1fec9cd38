"""A chain of edges as a person draws it: stop by stop, with the shortest way between stops."""


class ChainDrawing:
    """`graph` is a library.EdgeGraph. Going back over the chain shortens it; coming to its first
    vertex closes it."""

    def __init__(self, graph, chain, closed=False):
        self._graph = graph
        self.chain = list(chain)
        self.closed = closed
        self._places = {vertex: i for i, vertex in enumerate(self.chain)}

    @property
    def edge_count(self):
        return len(self.chain) - (0 if self.closed else 1)

    def vertices(self):
        """In order; the first again at the end of a closed chain."""
        return self.chain + self.chain[:1] if self.closed else list(self.chain)

    def extend_to(self, vertex):
        """Goes on to a vertex. -> False if no edges lead there or it is there already"""
        if vertex == (self.chain[0] if self.closed else self.chain[-1]):
            return False
        leg = self._graph.path(self.chain[-1], vertex)
        if not leg:
            return False
        # Past its beginning a loop stays one: the leg comes by the beginning again.
        self.closed = False
        for step in leg[1:]:
            self._go_to(step)
            if self.closed:
                break
        return True

    def _go_to(self, vertex):
        place = self._places.get(vertex)
        if place is None:
            self._places[vertex] = len(self.chain)
            self.chain.append(vertex)
        elif place == 0 and len(self.chain) > 2:
            self.closed = True
        else:
            for dropped in self.chain[place + 1 :]:
                del self._places[dropped]
            del self.chain[place + 1 :]
