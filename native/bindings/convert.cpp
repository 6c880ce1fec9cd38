#include "convert.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

namespace meshknit {
namespace {

template <class Array>
void require_three_columns(const Array& array, const char* name) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw InvalidInput(std::string(name) + " must have the shape (n, 3)");
}

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

}  // namespace

VertexArray to_vertices(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& array,
    const char* name) {
  require_three_columns(array, name);
  return Eigen::Map<const VertexArray>(array.data(), array.shape(0), 3);
}

FaceArray to_faces(const py::array_t<int, py::array::c_style | py::array::forcecast>& array,
                   const char* name) {
  require_three_columns(array, name);
  return Eigen::Map<const FaceArray>(array.data(), array.shape(0), 3);
}

py::dict to_python(const Problem& problem) {
  py::dict elements;
  const auto put = [&](const char* kind, const std::vector<int>& indices) {
    if (!indices.empty()) elements[kind] = py::cast(indices);
  };
  put("vertices", problem.elements.vertices);
  put("faces", problem.elements.faces);
  put("boundaries", problem.elements.boundaries);
  put("nodes", problem.elements.nodes);
  put("stitches", problem.elements.stitches);
  put("line", problem.elements.lines);
  if (!problem.elements.edges.empty()) {
    py::list edges;
    for (const auto& e : problem.elements.edges) edges.append(py::make_tuple(e[0], e[1]));
    elements["edges"] = edges;
  }
  py::dict result;
  result["code"] = problem.code;
  result["severity"] = name_of(problem.severity);
  result["message"] = problem.message;
  result["remedy"] = problem.remedy;
  result["elements"] = elements;
  return result;
}

py::list to_python(const Problems& problems) {
  py::list result;
  for (const Problem& p : problems) result.append(to_python(p));
  return result;
}

void put_marks(const std::vector<OpeningMark>& openings, const std::vector<TimeMark>& times,
               py::dict& into) {
  py::list opening_list, time_list;
  for (const OpeningMark& opening : openings) {
    py::dict entry;
    entry["at"] = opening.at;
    entry["radius"] = opening.radius;
    opening_list.append(entry);
  }
  for (const TimeMark& mark : times) {
    py::dict entry;
    entry["time"] = mark.time;
    if (mark.opening >= 0)
      entry["opening"] = mark.opening;
    else
      entry["boundary_near"] = mark.boundary_near;
    time_list.append(entry);
  }
  into["openings"] = opening_list;
  into["times"] = time_list;
}

py::array_t<double> to_input_order(const Surface& surface, const std::vector<double>& time) {
  std::vector<double> result(surface.vertex_of_source.size(),
                             std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < result.size(); ++row)
    if (surface.vertex_of_source[row] >= 0) result[row] = time[surface.vertex_of_source[row]];
  return to_array(result);
}

std::vector<double> from_input_order(
    const Surface& surface,
    const py::array_t<double, py::array::c_style | py::array::forcecast>& time) {
  if (time.ndim() != 1 ||
      time.shape(0) != static_cast<py::ssize_t>(surface.vertex_of_source.size()))
    throw InvalidInput("time must have one value per input vertex");
  std::vector<double> result(surface.source_vertex.size());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = time.at(surface.source_vertex[v]);
  return result;
}

std::vector<int> to_mesh_vertices(const Surface& surface, const std::vector<int>& rows) {
  std::vector<int> result;
  for (const int row : rows) {
    const bool inside = row >= 0 && row < static_cast<int>(surface.vertex_of_source.size());
    if (!inside || surface.vertex_of_source[row] < 0)
      throw InvalidInput("vertex " + std::to_string(row) + " is not part of the surface");
    result.push_back(surface.vertex_of_source[row]);
  }
  return result;
}

}  // namespace meshknit
