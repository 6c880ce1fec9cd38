#include "meshknit/surface/nearest_face.h"

#include <limits>

#include "meshknit/surface/segment.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

Vector3d nearest_on_segment(const Vector3d& a, const Vector3d& b, const Vector3d& point) {
  return a + nearest_along(a, b, point) * (b - a);
}

}  // namespace

std::array<Vector3d, 3> corners_of(const TriangleMesh& mesh, int face) {
  std::array<Vector3d, 3> corner;
  auto half = mesh.halfedge_handle(OpenMesh::FaceHandle(face));
  for (auto& c : corner) {
    c = mesh.point(mesh.from_vertex_handle(half));
    half = mesh.next_halfedge_handle(half);
  }
  return corner;
}

Vector3d nearest_in_triangle(const std::array<Vector3d, 3>& corner, const Vector3d& point) {
  const Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  bool inside = normal.squaredNorm() > 0.0;
  for (int k = 0; k < 3 && inside; ++k) {
    const Vector3d side = corner[(k + 1) % 3] - corner[k];
    inside = side.cross(point - corner[k]).dot(normal) >= 0.0;
  }
  if (inside) return point - normal * ((point - corner[0]).dot(normal) / normal.squaredNorm());
  Vector3d best = corner[0];
  for (int k = 0; k < 3; ++k) {
    const Vector3d place = nearest_on_segment(corner[k], corner[(k + 1) % 3], point);
    if ((place - point).squaredNorm() < (best - point).squaredNorm()) best = place;
  }
  return best;
}

SurfacePoint nearest_face(const TriangleMesh& mesh, const Vector3d& point) {
  SurfacePoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto f : mesh.faces()) {
    const Vector3d place = nearest_in_triangle(corners_of(mesh, f.idx()), point);
    const double squared = (place - point).squaredNorm();
    if (squared < least) {
      least = squared;
      nearest = {f.idx(), place};
    }
  }
  return nearest;
}

}  // namespace meshknit
