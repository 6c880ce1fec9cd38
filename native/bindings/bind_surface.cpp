#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/surface/edge_path.h"
#include "meshknit/surface/example_shapes.h"
#include "meshknit/time_field/field_from_values.h"
#include "meshknit/time_field/field_weights.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;
using Chain = std::pair<std::vector<int>, double>;

std::vector<TimeConstraint> to_constraints(const Surface& surface,
                                           const std::vector<Chain>& chains) {
  std::vector<TimeConstraint> constraints;
  for (const Chain& chain : chains)
    constraints.push_back({to_mesh_vertices(surface, chain.first), chain.second});
  return constraints;
}

std::vector<int> to_input_rows(const Surface& surface, std::vector<int> vertices) {
  for (int& v : vertices) v = surface.source_vertex[v];
  return vertices;
}

py::dict to_python(const TimeFieldCheck& check) {
  py::dict result;
  result["problems"] = to_python(check.problems);
  result["extrema"] = check.extrema;
  result["saddles"] = check.saddles;
  result["expected_saddles"] = check.expected_saddles;
  return result;
}

// A solver that keeps its factorisation while times are dragged.
struct LiveTimeField {
  LiveTimeField(const Surface& s, const FieldWeights& weights,
                const std::vector<std::vector<int>>& chains)
      : surface(s), solver(weights, chains) {}
  const Surface& surface;
  TimeFieldSolver solver;
};

py::dict shape_to_python(const ExampleShape& shape) {
  py::dict result;
  result["vertices"] = shape.vertices;
  result["faces"] = shape.faces;
  put_marks(shape.openings, shape.times, result);
  return result;
}

}  // namespace

void bind_surface(py::module_& m) {
  py::class_<Surface>(m, "Surface", py::module_local(),
                      "A checked surface. Vertices, edges and faces are named by the rows of "
                      "the arrays it was made from.")
      .def(py::init([](const Doubles& vertices, const Ints& faces, double stitch_width) {
             const VertexArray v = to_vertices(vertices, "vertices");
             const FaceArray f = to_faces(faces, "faces");
             SurfaceOptions options;
             options.stitch_width = stitch_width;
             py::gil_scoped_release release;
             return std::make_unique<Surface>(make_surface(v, f, options));
           }),
           py::arg("vertices"), py::arg("faces"),
           py::arg("stitch_width") = SurfaceOptions().stitch_width)
      .def_property_readonly("problems", [](const Surface& s) { return to_python(s.problems); })
      .def_property_readonly("ok", [](const Surface& s) { return !has_errors(s.problems); })
      .def_readonly("genus", &Surface::genus)
      .def_readonly("components", &Surface::components)
      .def_readonly("area", &Surface::area, "mm^2")
      .def_property_readonly(
          "boundaries",
          [](const Surface& s) {
            py::list loops;
            for (const BoundaryLoop& loop : s.boundaries) {
              py::dict entry;
              entry["vertices"] = to_input_rows(s, loop.vertices);
              entry["length"] = loop.length;
              loops.append(entry);
            }
            return loops;
          },
          "Boundary loops: vertices in order with the surface on their left, length in mm.")
      .def(
          "nearest_vertex",
          [](const Surface& s, const Eigen::Vector3d& point) {
            return to_input_rows(s, {nearest_vertex(s, point)})[0];
          },
          py::arg("point"))
      .def(
          "nearest_boundary",
          [](const Surface& s, const Eigen::Vector3d& point) {
            return nearest_boundary(s, point);
          },
          py::arg("point"))
      .def(
          "edge_path",
          [](const Surface& s, const std::vector<int>& vertices, bool closed) {
            return to_input_rows(s, edge_path(s, to_mesh_vertices(s, vertices), closed));
          },
          py::arg("vertices"), py::arg("closed") = false,
          "Shortest way along mesh edges through these vertices.");

  m.def(
      "field_from_values",
      [](const Surface& s, const Doubles& values) {
        const std::vector<double> given = from_input_order(s, values);
        std::vector<double> time;
        {
          py::gil_scoped_release release;
          time = field_from_values(s, given);
        }
        return to_input_order(s, time);
      },
      py::arg("surface"), py::arg("values"),
      "Any values, one a row of the surface -> times in [-1, 1] with one time on each "
      "boundary.");
  m.def(
      "distance_field",
      [](const Surface& s, const std::vector<int>& starts) {
        std::vector<double> time;
        {
          py::gil_scoped_release release;
          time = distance_field(s, starts);
        }
        return to_input_order(s, time);
      },
      py::arg("surface"), py::arg("starts"),
      "The geodesic distance from these boundaries as times in [-1, 1].");
  m.def(
      "mend_field",
      [](const Surface& s, const Doubles& time) {
        const std::vector<double> given = from_input_order(s, time);
        MendedField mended;
        {
          py::gil_scoped_release release;
          mended = mend_field(s, given);
        }
        return py::make_tuple(to_input_order(s, mended.time), mended.changed, mended.most);
      },
      py::arg("surface"), py::arg("time"),
      "-> (times without false extrema, vertices changed, largest change as a share of the "
      "range).");
  m.def(
      "check_constraints",
      [](const Surface& s, const std::vector<Chain>& chains) {
        return to_python(check_constraints(s, to_constraints(s, chains)));
      },
      py::arg("surface"), py::arg("constraints"), "Problems of a list of (vertices, time).");
  m.def(
      "solve_time_field",
      [](const Surface& s, const std::vector<Chain>& chains) {
        const std::vector<TimeConstraint> constraints = to_constraints(s, chains);
        TimeField field;
        {
          py::gil_scoped_release release;
          field = solve_time_field(s, constraints);
        }
        return py::make_tuple(to_input_order(s, field.time), to_python(field.check));
      },
      py::arg("surface"), py::arg("constraints"),
      "Harmonic interpolation of (vertices, time) -> (one time per input vertex, its check).");
  m.def(
      "check_time_field",
      [](const Surface& s, const Doubles& time) {
        return to_python(check_time_field(s, from_input_order(s, time)));
      },
      py::arg("surface"), py::arg("time"));

  py::class_<FieldWeights>(m, "FieldWeights", py::module_local(),
                           "What all fields of a surface share, wherever their chains lie.")
      .def(py::init([](const Surface& s) {
             py::gil_scoped_release release;
             return std::make_unique<FieldWeights>(field_weights(s));
           }),
           py::arg("surface"));
  py::class_<LiveTimeField>(
      m, "LiveTimeField", py::module_local(),
      "Keeps its factorisation: new times for the same chains cost one back-solve.")
      .def(py::init([](const Surface& s, const FieldWeights& weights,
                       const std::vector<std::vector<int>>& chains) {
             std::vector<std::vector<int>> vertices;
             for (const auto& chain : chains) vertices.push_back(to_mesh_vertices(s, chain));
             py::gil_scoped_release release;
             return std::make_unique<LiveTimeField>(s, weights, vertices);
           }),
           py::arg("surface"), py::arg("weights"), py::arg("chains"), py::keep_alive<1, 2>())
      .def(
          "solve",
          [](const LiveTimeField& f, const std::vector<double>& times) {
            return to_input_order(f.surface, f.solver.solve(times));
          },
          py::arg("times"));

  m.def("example_shape_names", &example_shape_names);
  m.def(
      "example_shape",
      [](const std::string& name) { return shape_to_python(example_shape(name)); },
      py::arg("name"),
      "An example shape with its default sizes: vertices (mm), faces, and what a marks file "
      "says: times and openings.");
  m.def(
      "straight_tube",
      [](double radius, double length) {
        return shape_to_python(straight_tube(radius, length));
      },
      py::arg("radius"), py::arg("length"));
  m.def(
      "cone",
      [](double start_radius, double end_radius, double height) {
        return shape_to_python(cone(start_radius, end_radius, height));
      },
      py::arg("start_radius"), py::arg("end_radius"), py::arg("height"));
  m.def(
      "bent_tube",
      [](double degrees, double radius, double leg) {
        return shape_to_python(bent_tube(degrees, radius, leg));
      },
      py::arg("degrees"), py::arg("radius"), py::arg("leg"));
  m.def("sock", []() { return shape_to_python(sock()); });
}

}  // namespace meshknit
