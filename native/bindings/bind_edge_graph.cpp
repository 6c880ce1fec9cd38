#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/surface/edge_graph.h"

namespace meshknit {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;

EdgeArray to_edges(const Ints& array) {
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw InvalidInput("edges must be an array of shape (n, 2)");
  return Eigen::Map<const EdgeArray>(array.data(), array.shape(0), 2);
}

}  // namespace

void bind_edge_graph(py::module_& m) {
  py::class_<EdgeGraph>(m, "EdgeGraph", py::module_local(),
                        "The edges of a mesh of polygons, for shortest paths along them.")
      .def(py::init([](const Doubles& positions, const Ints& edges) {
             const VertexArray places = to_vertices(positions, "positions");
             const EdgeArray pairs = to_edges(edges);
             py::gil_scoped_release release;
             return std::make_unique<EdgeGraph>(places, pairs);
           }),
           py::arg("positions"), py::arg("edges"))
      .def("path", &EdgeGraph::path, py::arg("start"), py::arg("goal"),
           py::call_guard<py::gil_scoped_release>(),
           "Vertices of a shortest path, both ends included; [] if there is none.")
      .def("edges_along", &EdgeGraph::edges_along, py::arg("chain"),
           "Rows of the edges along a chain of vertices.");
}

}  // namespace meshknit
