#include "convert.h"

PYBIND11_MODULE(_native, m) {
  m.doc() =
      "meshknit's library: surface, time field, knit graph, trace, schedule, machine file. "
      "Lengths are millimetres; vertices and faces are rows of the caller's arrays.";
  meshknit::bind_core(m);
  meshknit::bind_surface(m);
  meshknit::bind_edge_graph(m);
  meshknit::bind_openings(m);
  meshknit::bind_graph(m);
  meshknit::bind_machine(m);
  meshknit::bind_suggest(m);
}
