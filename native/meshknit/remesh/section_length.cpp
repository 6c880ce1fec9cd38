#include "meshknit/remesh/section_length.h"

#include <Eigen/Geometry>

namespace meshknit {
namespace {

// Stitches cross a handful of triangles; a longer walk has missed its end.
constexpr int most_triangles = 200;

Eigen::Vector3d normal_of(const TriangleMesh& mesh, int face) {
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(face));
  const Eigen::Vector3d& a = mesh.point(mesh.from_vertex_handle(h));
  const Eigen::Vector3d& b = mesh.point(mesh.to_vertex_handle(h));
  const Eigen::Vector3d& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  return (b - a).cross(c - a).normalized();
}

}  // namespace

double section_length(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to) {
  const Eigen::Vector3d straight = to.position - from.position;
  if (from.face == to.face) return straight.norm();
  const Eigen::Vector3d plane =
      straight.cross(normal_of(mesh, from.face) + normal_of(mesh, to.face));
  const auto side = [&](TriangleMesh::VertexHandle v) {
    return plane.dot(mesh.point(v) - from.position);
  };
  double length = 0.0;
  Eigen::Vector3d at = from.position;
  auto entered = TriangleMesh::HalfedgeHandle();
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(from.face));
  for (int step = 0; step < most_triangles; ++step) {
    // Of the triangle's edges that the plane crosses, leave by the one that leads on.
    auto out = TriangleMesh::HalfedgeHandle();
    Eigen::Vector3d out_at;
    for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
      if (h == entered) continue;
      const double a = side(mesh.from_vertex_handle(h)), b = side(mesh.to_vertex_handle(h));
      if ((a < 0.0) == (b < 0.0)) continue;
      const Eigen::Vector3d& p = mesh.point(mesh.from_vertex_handle(h));
      const Eigen::Vector3d cut = p + a / (a - b) * (mesh.point(mesh.to_vertex_handle(h)) - p);
      if (!out.is_valid() || (cut - out_at).dot(straight) > 0.0) {
        out = h;
        out_at = cut;
      }
    }
    if (!out.is_valid()) break;
    length += (out_at - at).norm();
    at = out_at;
    entered = mesh.opposite_halfedge_handle(out);
    if (mesh.is_boundary(entered)) break;
    if (mesh.face_handle(entered).idx() == to.face) return length + (to.position - at).norm();
    h = entered;
  }
  return straight.norm();
}

}  // namespace meshknit
