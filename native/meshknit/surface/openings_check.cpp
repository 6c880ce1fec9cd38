#include <algorithm>
#include <set>

#include "meshknit/core/error.h"
#include "meshknit/surface/nearest_face.h"
#include "meshknit/surface/openings.h"

namespace meshknit {
namespace {

// Of the object's size: doubled vertices within a millionth of it were joined.
constexpr double seam = 1e-5;
// The rim's promise.
constexpr double rim_error = 0.02;

Problem broken(const std::string& code, const std::string& message) {
  return {code, Severity::error, message, "Please report this with the model.", {}};
}

std::array<Eigen::Vector3d, 3> corners(const VertexArray& vertices, const FaceArray& faces,
                                       int face) {
  return {Eigen::Vector3d(vertices.row(faces(face, 0))),
          Eigen::Vector3d(vertices.row(faces(face, 1))),
          Eigen::Vector3d(vertices.row(faces(face, 2)))};
}

bool lies_in_source(const VertexArray& vertices, const FaceArray& faces, const CutSurface& cut,
                    int face, double slack) {
  const auto source = corners(vertices, faces, cut.source_face[face]);
  for (const Eigen::Vector3d& corner : corners(cut.vertices, cut.faces, face))
    if ((nearest_in_triangle(source, corner) - corner).norm() > slack) return false;
  return true;
}

int characteristic(const Surface& surface) {
  return static_cast<int>(surface.mesh.n_vertices()) -
         static_cast<int>(surface.mesh.n_edges()) + static_cast<int>(surface.mesh.n_faces());
}

void check_rims(const std::vector<OpeningMark>& marks, const Surface& whole,
                const Surface& left, const CutSurface& cut, Problems& problems) {
  std::set<std::vector<int>> loops;
  for (const BoundaryLoop& loop : left.boundaries) {
    std::vector<int> rows;
    for (const int v : loop.vertices) rows.push_back(left.source_vertex[v]);
    loops.insert(std::move(rows));
  }
  for (const Opening& opening : cut.openings) {
    if (loops.count(opening.rim) == 0)
      problems.push_back(
          broken("cut-rim-not-boundary", "A rim is no boundary of what is left."));
    if (opening.mark < 0) continue;
    const OpeningMark& mark = marks[opening.mark];
    const Eigen::Vector3d place = nearest_face(whole.mesh, mark.at).position;
    // The straight way is never longer than the one along the surface.
    for (const int v : opening.rim)
      if ((Eigen::Vector3d(cut.vertices.row(v)) - place).norm() >
          (1.0 + rim_error) * mark.radius) {
        problems.push_back(
            broken("cut-rim-distance", "A rim is further away than its radius."));
        break;
      }
  }
}

}  // namespace

Problems check_cut(const VertexArray& vertices, const FaceArray& faces,
                   const std::vector<OpeningMark>& marks, const CutSurface& cut) {
  Problems problems;
  if (has_errors(cut.problems)) return problems;
  const double size = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
  for (std::size_t v = 0; v < cut.source_vertex.size(); ++v) {
    const int source = cut.source_vertex[v];
    if (source < 0 || cut.vertices.row(static_cast<Eigen::Index>(v)) == vertices.row(source))
      continue;
    problems.push_back(broken("cut-moved-vertex", "A vertex of the mesh has moved."));
    break;
  }
  for (int f = 0; f < static_cast<int>(cut.source_face.size()); ++f) {
    if (lies_in_source(vertices, faces, cut, f, seam * size)) continue;
    problems.push_back(broken("cut-off-surface", "A face left its place on the surface."));
    break;
  }
  const Surface whole = make_surface(vertices, faces),
                left = make_surface(cut.vertices, cut.faces);
  check_rims(marks, whole, left, cut, problems);
  const bool only_marks = std::all_of(cut.openings.begin(), cut.openings.end(),
                                      [](const Opening& o) { return o.mark >= 0; });
  const int expected = characteristic(whole) - static_cast<int>(cut.openings.size());
  if (only_marks && find_problem(cut.problems, "part-left-out") == nullptr &&
      characteristic(left) != expected)
    problems.push_back(
        broken("cut-characteristic", "Openings are missing, or there are too many."));
  return problems;
}

}  // namespace meshknit
