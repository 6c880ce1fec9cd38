#include "meshknit/remesh/section_length.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace meshknit {
namespace {

// A way that is so many times longer than the straight one goes round the object, not over an edge.
constexpr double most_detour = 4.0;

Eigen::Vector3d normal_of(const TriangleMesh& mesh, int face) {
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(face));
  const Eigen::Vector3d& a = mesh.point(mesh.from_vertex_handle(h));
  const Eigen::Vector3d& b = mesh.point(mesh.to_vertex_handle(h));
  const Eigen::Vector3d& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  return (b - a).cross(c - a).normalized();
}

// Walks on in the plane from a triangle's edge until the end's triangle; infinite if it is not met before
// the way is longer than `most`.
double length_from(const TriangleMesh& mesh, TriangleMesh::HalfedgeHandle out,
                   const FacePoint& from, const FacePoint& to, const Eigen::Vector3d& plane,
                   double most) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto side = [&](TriangleMesh::VertexHandle v) {
    return plane.dot(mesh.point(v) - from.position);
  };
  double length = 0.0;
  Eigen::Vector3d at = from.position;
  while (out.is_valid() && length < most) {
    const auto u = mesh.from_vertex_handle(out), w = mesh.to_vertex_handle(out);
    const double a = side(u), b = side(w);
    const Eigen::Vector3d cut = mesh.point(u) + a / (a - b) * (mesh.point(w) - mesh.point(u));
    length += (cut - at).norm();
    at = cut;
    const auto entered = mesh.opposite_halfedge_handle(out);
    if (mesh.is_boundary(entered)) return never;
    if (mesh.face_handle(entered).idx() == to.face) return length + (to.position - at).norm();
    // The plane leaves a triangle by one of its two other edges.
    out = mesh.next_halfedge_handle(entered);
    if ((side(mesh.from_vertex_handle(out)) < 0.0) == (side(mesh.to_vertex_handle(out)) < 0.0))
      out = mesh.next_halfedge_handle(out);
    if ((side(mesh.from_vertex_handle(out)) < 0.0) == (side(mesh.to_vertex_handle(out)) < 0.0))
      return never;
  }
  return never;
}

}  // namespace

double section_length(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to) {
  const Eigen::Vector3d straight = to.position - from.position;
  if (from.face == to.face) return straight.norm();
  const Eigen::Vector3d plane =
      straight.cross(normal_of(mesh, from.face) + normal_of(mesh, to.face));
  // Over a sharp edge the way may begin backwards: try both, the shorter counts.
  double shortest = most_detour * straight.norm();
  bool met = false;
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(from.face));
  for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
    const double a = plane.dot(mesh.point(mesh.from_vertex_handle(h)) - from.position);
    const double b = plane.dot(mesh.point(mesh.to_vertex_handle(h)) - from.position);
    if ((a < 0.0) == (b < 0.0)) continue;
    const double length = length_from(mesh, h, from, to, plane, shortest);
    met = met || length < shortest;
    shortest = std::min(shortest, length);
  }
  return met ? shortest : straight.norm();
}

}  // namespace meshknit
