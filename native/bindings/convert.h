#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/surface/example_shapes.h"
#include "meshknit/surface/surface.h"

namespace py = pybind11;

namespace meshknit {

// Conversions at the border. Arrays are checked for shape, and messages name the argument.

VertexArray to_vertices(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& array,
    const char* name);
FaceArray to_faces(const py::array_t<int, py::array::c_style | py::array::forcecast>& array,
                   const char* name);

py::dict to_python(const Problem& problem);
py::list to_python(const Problems& problems);

template <class T>
py::array_t<T> to_array(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// A two-dimensional array from rows laid end to end.
template <class T>
py::array_t<T> to_table(const std::vector<T>& values, py::ssize_t columns) {
  return py::array_t<T>({static_cast<py::ssize_t>(values.size()) / columns, columns},
                        values.data());
}

/// Puts `openings` and `times` in the form of a marks file (mm) into a dict.
void put_marks(const std::vector<OpeningMark>& openings, const std::vector<TimeMark>& times,
               py::dict& into);

/// Field values per input row: vertices that are not part of the surface get NaN.
py::array_t<double> to_input_order(const Surface& surface, const std::vector<double>& time);
/// The other way round. Throws InvalidInput for a wrong length.
std::vector<double> from_input_order(
    const Surface& surface,
    const py::array_t<double, py::array::c_style | py::array::forcecast>& time);

/// Input rows -> mesh vertices. Throws InvalidInput for rows out of range or not part of the
/// surface.
std::vector<int> to_mesh_vertices(const Surface& surface, const std::vector<int>& rows);

void bind_core(py::module_& m);
void bind_surface(py::module_& m);
void bind_edge_graph(py::module_& m);
void bind_graph(py::module_& m);
void bind_openings(py::module_& m);
void bind_machine(py::module_& m);
void bind_suggest(py::module_& m);

}  // namespace meshknit
