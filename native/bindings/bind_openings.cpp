#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/surface/openings.h"

namespace meshknit {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;
using Mark = std::pair<Eigen::Vector3d, double>;

CutSurface checked_cut(const VertexArray& vertices, const FaceArray& faces,
                       const std::vector<int>& face_marks,
                       const std::vector<OpeningMark>& marks, const SurfaceOptions& options) {
  CutSurface cut = cut_openings(vertices, faces, face_marks, marks, options);
  const Problems broken = check_cut(vertices, faces, marks, cut);
  if (!broken.empty())
    throw BrokenPromise("openings: " + broken.front().code + ": " + broken.front().message);
  return cut;
}

py::list openings_to_python(const CutSurface& cut) {
  py::list result;
  for (const Opening& opening : cut.openings) {
    py::dict entry;
    entry["mark"] = opening.mark;
    entry["face_mark"] = opening.face_mark;
    entry["faces"] = opening.faces;
    entry["rim"] = opening.rim;
    entry["rim_length"] = opening.rim_length;
    result.append(entry);
  }
  return result;
}

}  // namespace

void bind_openings(py::module_& m) {
  py::class_<CutSurface>(m, "CutSurface", py::module_local(),
                         "A mesh without its openings; problems name rows of the input.")
      .def_property_readonly("problems",
                             [](const CutSurface& c) { return to_python(c.problems); })
      .def_property_readonly("ok", [](const CutSurface& c) { return !has_errors(c.problems); })
      .def_readonly("vertices", &CutSurface::vertices, "mm")
      .def_readonly("faces", &CutSurface::faces)
      .def_property_readonly(
          "source_vertex", [](const CutSurface& c) { return to_array(c.source_vertex); },
          "New vertex -> row of the input, -1 on a cut.")
      .def_property_readonly(
          "vertex_of_source", [](const CutSurface& c) { return to_array(c.vertex_of_source); },
          "Row of the input -> new vertex, -1 if it was left out.")
      .def_property_readonly("source_face",
                             [](const CutSurface& c) { return to_array(c.source_face); })
      .def_property_readonly("openings", &openings_to_python,
                             "mark (-1 for faces), face_mark, faces, rim, rim_length (mm).");
  m.def(
      "cut_openings",
      [](const Doubles& vertices, const Ints& faces, const std::vector<int>& face_marks,
         const std::vector<Mark>& marks, double stitch_width) {
        const VertexArray v = to_vertices(vertices, "vertices");
        const FaceArray f = to_faces(faces, "faces");
        std::vector<OpeningMark> places;
        for (const auto& [at, radius] : marks) places.push_back({at, radius});
        SurfaceOptions options;
        options.stitch_width = stitch_width;
        py::gil_scoped_release release;
        return std::make_unique<CutSurface>(checked_cut(v, f, face_marks, places, options));
      },
      py::arg("vertices"), py::arg("faces"), py::arg("face_marks"), py::arg("marks"),
      py::arg("stitch_width") = SurfaceOptions().stitch_width,
      "Leaves out the faces whose mark is not 0 ([] for none) and the surface within each mark "
      "(place, radius in mm).");
}

}  // namespace meshknit
