#include <cmath>
#include <set>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/surface/wording.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {
namespace {

Problem error(const std::string& code, const std::string& message, const std::string& remedy) {
  return {code, Severity::error, message, remedy, {}};
}

std::string boundary_text(const Surface& surface, int boundary) {
  const int first = surface.boundaries[boundary].vertices.front();
  return "opening near " + place_text(surface.mesh.point(OpenMesh::VertexHandle(first)));
}

void name_boundary(const Surface& surface, int boundary, Problem& problem) {
  problem.elements.boundaries = {boundary};
  for (const int v : surface.boundaries[boundary].vertices)
    problem.elements.vertices.push_back(surface.source_vertex[v]);
}

void check_values(const std::vector<TimeConstraint>& constraints, Problems& problems) {
  std::set<double> times;
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const double time = constraints[c].time;
    if (!(time >= -1.0 && time <= 1.0))
      problems.push_back(
          error("time-out-of-range",
                "Constraint " + std::to_string(c) + " has a time outside -1 to 1.",
                "Give it a time from -1 (knit first) to 1 (knit last)."));
    if (constraints[c].vertices.empty())
      problems.push_back(error(
          "empty-constraint", "Constraint " + std::to_string(c) + " holds no part of the mesh.",
          "Draw it again on the present mesh, or delete it."));
    if (std::isfinite(time)) times.insert(time);
  }
  if (times.size() < 2)
    problems.push_back(
        error("all-times-equal",
              times.empty() ? "No part of the mesh has a knitting time."
                            : "All constraints have the same time.",
              "Give one opening an early time (-1: start) and one a late time (1: end)."));
}

// The times that constraints give to each vertex, ascending.
using VertexTimes = std::vector<std::set<double>>;

void check_boundary(const Surface& surface, int boundary, const VertexTimes& times,
                    Problems& problems) {
  std::set<double> found;
  std::vector<int> without;
  for (const int v : surface.boundaries[boundary].vertices) {
    found.insert(times[v].begin(), times[v].end());
    if (times[v].empty()) without.push_back(surface.source_vertex[v]);
  }
  const std::string where = boundary_text(surface, boundary);
  if (found.size() > 1) {
    problems.push_back(
        error("boundary-with-two-times", "The " + where + " has more than one time.",
              "An opening is knit at one time: delete all but one of its constraints, and keep "
              "constraints of the inside away from it."));
    name_boundary(surface, boundary, problems.back());
  } else if (!without.empty()) {
    problems.push_back(error(
        "boundary-without-time",
        "The " + where + (found.empty() ? " has no time." : " has a time on a part only."),
        "Give the whole opening a time, or close it."));
    name_boundary(surface, boundary, problems.back());
    problems.back().elements.vertices = without;
  }
}

void check_inside(const Surface& surface, const VertexTimes& times, Problems& problems) {
  std::vector<int> contradictory;
  for (std::size_t v = 0; v < times.size(); ++v)
    if (times[v].size() > 1 &&
        !surface.mesh.is_boundary(OpenMesh::VertexHandle(static_cast<int>(v))))
      contradictory.push_back(static_cast<int>(v));
  if (contradictory.empty()) return;
  const Eigen::Vector3d at = surface.mesh.point(OpenMesh::VertexHandle(contradictory.front()));
  problems.push_back(error("contradictory-times",
                           "Constraints with different times meet near " + place_text(at) + ".",
                           "Move them apart, or give them the same time."));
  for (const int v : contradictory)
    problems.back().elements.vertices.push_back(surface.source_vertex[v]);
}

}  // namespace

Problems check_constraints(const Surface& surface,
                           const std::vector<TimeConstraint>& constraints) {
  Problems problems;
  check_values(constraints, problems);
  VertexTimes times(surface.mesh.n_vertices());
  for (std::size_t c = 0; c < constraints.size(); ++c)
    for (const int v : constraints[c].vertices) {
      if (v < 0 || v >= static_cast<int>(times.size()))
        throw InvalidInput("constraint " + std::to_string(c) + " names vertex " +
                           std::to_string(v) + ", which the mesh does not have");
      if (std::isfinite(constraints[c].time)) times[v].insert(constraints[c].time);
    }
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b)
    check_boundary(surface, static_cast<int>(b), times, problems);
  check_inside(surface, times, problems);
  return problems;
}

}  // namespace meshknit
