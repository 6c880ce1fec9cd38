#include "meshknit/remesh/section_length.h"

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <utility>

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

constexpr double never = std::numeric_limits<double>::infinity();

// Direction of a way's first piece, which has no length if the point lies on the edge.
Eigen::Vector3d direction(const Eigen::Vector3d& way, const Eigen::Vector3d& otherwise) {
  const double length = way.norm();
  return length > 0.0 ? Eigen::Vector3d(way / length) : otherwise;
}

// Walks on in the plane from a triangle's edge until the end's triangle. Its length is infinite if that
// is not met before the way is longer than `most`.
Section section_from(const TriangleMesh& mesh, TriangleMesh::HalfedgeHandle out,
                     const FacePoint& from, const FacePoint& to, const Eigen::Vector3d& plane,
                     double most) {
  const Eigen::Vector3d straight = (to.position - from.position).normalized();
  Section section{never, straight, -straight};
  const auto side = [&](TriangleMesh::VertexHandle v) {
    return plane.dot(mesh.point(v) - from.position);
  };
  double length = 0.0;
  Eigen::Vector3d at = from.position;
  while (out.is_valid() && length < most) {
    const auto u = mesh.from_vertex_handle(out), w = mesh.to_vertex_handle(out);
    const double a = side(u), b = side(w);
    const Eigen::Vector3d cut = mesh.point(u) + a / (a - b) * (mesh.point(w) - mesh.point(u));
    if (length == 0.0) section.from_first = direction(cut - from.position, straight);
    length += (cut - at).norm();
    at = cut;
    const auto entered = mesh.opposite_halfedge_handle(out);
    if (mesh.is_boundary(entered)) return section;
    if (mesh.face_handle(entered).idx() == to.face) {
      section.length = length + (to.position - at).norm();
      section.from_last = direction(at - to.position, -straight);
      return section;
    }
    // The plane leaves a triangle by one of its two other edges.
    out = mesh.next_halfedge_handle(entered);
    if ((side(mesh.from_vertex_handle(out)) < 0.0) == (side(mesh.to_vertex_handle(out)) < 0.0))
      out = mesh.next_halfedge_handle(out);
    if ((side(mesh.from_vertex_handle(out)) < 0.0) == (side(mesh.to_vertex_handle(out)) < 0.0))
      return section;
  }
  return section;
}

}  // namespace

Section section(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to) {
  const Eigen::Vector3d straight = to.position - from.position;
  const double distance = straight.norm();
  Section shortest{distance, straight / distance, -straight / distance};
  if (from.face == to.face) return shortest;
  const Eigen::Vector3d plane =
      straight.cross(normal_of(mesh, from.face) + normal_of(mesh, to.face));
  // Over a sharp edge the way may begin backwards: both are tried, the likely one first, and the
  // shorter counts.
  std::array<TriangleMesh::HalfedgeHandle, 2> out;
  std::array<double, 2> ahead = {0.0, 0.0};
  int count = 0;
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(from.face));
  for (int k = 0; k < 3 && count < 2; ++k, h = mesh.next_halfedge_handle(h)) {
    const Eigen::Vector3d u = mesh.point(mesh.from_vertex_handle(h)) - from.position;
    const Eigen::Vector3d w = mesh.point(mesh.to_vertex_handle(h)) - from.position;
    const double a = plane.dot(u), b = plane.dot(w);
    if ((a < 0.0) == (b < 0.0)) continue;
    out[count] = h;
    ahead[count++] = straight.dot(u + a / (a - b) * (w - u));
  }
  if (ahead[1] > ahead[0]) std::swap(out[0], out[1]);
  double most = most_detour * distance;
  for (int k = 0; k < count; ++k) {
    const Section way = section_from(mesh, out[k], from, to, plane, most);
    if (way.length >= most) continue;
    shortest = way;
    most = way.length;
  }
  return shortest;
}

double section_length(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to) {
  if (from.position == to.position) return 0.0;
  return section(mesh, from, to).length;
}

}  // namespace meshknit
