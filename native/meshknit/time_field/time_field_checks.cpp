#include <algorithm>
#include <cmath>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/surface/wording.h"
#include "meshknit/time_field/critical_spots.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {
namespace {

constexpr double kConstantTolerance = 1e-6;  // of the field's range
constexpr double kStandstillArea = 0.01;     // of the surface

Problem problem(const std::string& code, Severity severity, const std::string& message,
                const std::string& remedy) {
  return {code, severity, message, remedy, {}};
}

std::string near_vertex(const Surface& surface, int vertex) {
  return "near " + place_text(surface.mesh.point(OpenMesh::VertexHandle(vertex)));
}

void name_vertices(const Surface& surface, const std::vector<int>& vertices, Problem& named) {
  for (const int v : vertices) named.elements.vertices.push_back(surface.source_vertex[v]);
}

bool check_finite(const Surface& surface, const std::vector<double>& time, Problems& problems) {
  std::vector<int> bad;
  for (std::size_t v = 0; v < time.size(); ++v)
    if (!std::isfinite(time[v])) bad.push_back(static_cast<int>(v));
  if (bad.empty()) return true;
  problems.push_back(problem("time-not-finite", Severity::error,
                             counted(bad.size(), "vertex has", "vertices have") +
                                 " a knitting time that is not a number.",
                             "Solve the time field again, or paint these vertices."));
  name_vertices(surface, bad, problems.back());
  return false;
}

// Which boundaries have one time. Differences within the tolerance are levelled.
std::vector<bool> check_constant(const Surface& surface, std::vector<double>& time,
                                 Problems& problems) {
  const auto [low, high] = std::minmax_element(time.begin(), time.end());
  const double tolerance = kConstantTolerance * (*high - *low);
  std::vector<bool> constant;
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b) {
    const auto& loop = surface.boundaries[b].vertices;
    const auto earlier = [&](int v, int w) { return time[v] < time[w]; };
    const auto [first, last] = std::minmax_element(loop.begin(), loop.end(), earlier);
    constant.push_back(time[*last] - time[*first] <= tolerance);
    if (constant.back()) {
      const double level = time[loop.front()];
      for (const int v : loop) time[v] = level;
    } else {
      problems.push_back(
          problem("boundary-not-constant", Severity::error,
                  "The time changes along the opening " + near_vertex(surface, *first) + ".",
                  "Give all vertices of the opening the same time."));
      problems.back().elements.boundaries = {static_cast<int>(b)};
      name_vertices(surface, {*first, *last}, problems.back());
    }
  }
  return constant;
}

void report_false_extrema(const Surface& surface, const std::vector<const TimeSpot*>& extrema,
                          Problems& problems) {
  if (extrema.empty()) return;
  problems.push_back(problem(
      "false-extremum", Severity::error,
      "At " + counted(extrema.size(), "place", "places") +
          " away from the openings the time is earlier or later than all round (the first " +
          near_vertex(surface, extrema.front()->vertices.front()) +
          "); knitting would have to start or end there.",
      "Make an opening there, smooth the time, or change the times of constraints inside so "
      "that "
      "each lies between the times beside it."));
  for (const TimeSpot* spot : extrema) name_vertices(surface, spot->vertices, problems.back());
}

void report_passing(const Surface& surface, const TimeSpot& spot, Problems& problems) {
  for (const int b : spot.boundaries) {
    problems.push_back(
        problem("boundary-in-passing", Severity::error,
                "The opening " + near_vertex(surface, surface.boundaries[b].vertices.front()) +
                    " has earlier and later cloth beside it; an opening must be a start (all "
                    "beside it is "
                    "later) or an end (all is earlier).",
                "Give it an earlier or a later time, or close it and cut it after knitting."));
    problems.back().elements.boundaries = {b};
    name_vertices(surface, surface.boundaries[b].vertices, problems.back());
  }
}

void check_standstill(const Surface& surface, const std::vector<double>& time,
                      Problems& problems) {
  const TriangleMesh& mesh = surface.mesh;
  double area = 0.0;
  std::vector<int> faces;
  for (const auto f : mesh.faces()) {
    const auto corner = mesh.cfv_iter(f);
    const double here = time[corner->idx()];
    bool flat = true;
    for (const auto v : mesh.fv_range(f)) flat = flat && time[v.idx()] == here;
    if (!flat) continue;
    area += mesh.calc_face_area(f);
    faces.push_back(surface.source_face[f.idx()]);
  }
  if (area <= kStandstillArea * surface.area) return;
  const bool everywhere = faces.size() == mesh.n_faces();
  problems.push_back(problem(
      "time-stands-still", everywhere ? Severity::error : Severity::warning,
      everywhere ? "The time is the same everywhere."
                 : "The time stands still on " + counted(faces.size(), "face", "faces") +
                       "; there it cannot say which way the rows run.",
      "Let the time rise from the start to the end; solving it from constraints does."));
  problems.back().elements.faces = std::move(faces);
}

}  // namespace

TimeFieldCheck check_time_field(const Surface& surface, const std::vector<double>& time) {
  if (time.size() != surface.mesh.n_vertices())
    throw InvalidInput("check_time_field: one time is needed for every mesh vertex");
  const int boundaries = static_cast<int>(surface.boundaries.size());
  TimeFieldCheck check;
  check.expected_saddles = 2 * surface.genus - 2 + boundaries;
  if (time.empty() || !check_finite(surface, time, check.problems)) return check;

  std::vector<double> level = time;
  const std::vector<bool> constant = check_constant(surface, level, check.problems);
  const std::vector<TimeSpot> spots = time_spots(surface, level, constant);
  check_standstill(surface, level, check.problems);
  if (spots.size() == 1) return check;

  std::vector<const TimeSpot*> extrema;
  bool start = false, end = false;
  for (const TimeSpot& spot : spots) {
    const int filled = static_cast<int>(spot.boundaries.size());
    if (filled == 0 && spot.is_extremum()) {
      extrema.push_back(&spot);
      continue;
    }
    // Signs round a spot on a varying boundary do not close up, so they do not count.
    if (!spot.on_varying_boundary)
      check.saddles += spot.sign_changes / 2 - spot.characteristic + filled;
    if (filled == 0) continue;
    start = start || !spot.has_earlier;
    end = end || !spot.has_later;
    if (!spot.is_extremum()) report_passing(surface, spot, check.problems);
  }
  check.extrema = static_cast<int>(extrema.size());
  report_false_extrema(surface, extrema, check.problems);
  if (!start)
    check.problems.push_back(
        problem("no-start", Severity::error,
                "No opening is earlier than the cloth beside it: knitting cannot start.",
                "Give one opening the earliest time, -1."));
  if (!end)
    check.problems.push_back(
        problem("no-end", Severity::error,
                "No opening is later than the cloth beside it: knitting cannot end.",
                "Give one opening the latest time, 1."));
  return check;
}

}  // namespace meshknit
