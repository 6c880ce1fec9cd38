#include "meshknit/remesh/section_length.h"

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <utility>

namespace meshknit {
namespace {

// A way that is so many times longer than the straight one goes round the object, not over an edge.
constexpr double most_detour = 4.0;

constexpr double never = std::numeric_limits<double>::infinity();

// Direction of a way's first piece, which has no length if the point lies on the edge.
Eigen::Vector3d direction(const Eigen::Vector3d& way, const Eigen::Vector3d& otherwise) {
  const double length = way.norm();
  return length > 0.0 ? Eigen::Vector3d(way / length) : otherwise;
}

// An edge of the first triangle that the plane crosses.
struct Crossed {
  TriangleMesh::HalfedgeHandle edge;
  double from_beside = 0.0,
         to_beside = 0.0;  // of its ends, from the plane, times the normal's length
  double ahead = 0.0;      // where it is crossed, towards the other point
};

// Walks on in the plane from a triangle's edge, whose ends lie so far beside the plane, until the end's
// triangle. Its length is infinite if that is not met before the way is longer than `most`.
Section section_from(const TriangleMesh& mesh, const Crossed& edge, const FacePoint& from,
                     const FacePoint& to, const Eigen::Vector3d& plane, double most) {
  const Eigen::Vector3d straight = (to.position - from.position).normalized();
  Section section{never, straight, -straight};
  auto [out, a, b, ahead] = edge;
  Eigen::Vector3d u = mesh.point(mesh.from_vertex_handle(out));
  Eigen::Vector3d w = mesh.point(mesh.to_vertex_handle(out));
  double length = 0.0;
  Eigen::Vector3d at = from.position;
  while (length < most) {
    const Eigen::Vector3d cut = u + a / (a - b) * (w - u);
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
    // The plane leaves the triangle by the edge whose ends it parts, from u or to w.
    out = mesh.next_halfedge_handle(entered);
    const Eigen::Vector3d& third = mesh.point(mesh.to_vertex_handle(out));
    const double side = plane.dot(third - from.position);
    if ((a < 0.0) != (side < 0.0)) {
      w = third;
      b = side;
    } else {
      out = mesh.next_halfedge_handle(out);
      u = third;
      a = side;
    }
  }
  return section;
}

}  // namespace

Eigen::Vector3d face_normal(const TriangleMesh& mesh, int face) {
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(face));
  const Eigen::Vector3d& a = mesh.point(mesh.from_vertex_handle(h));
  const Eigen::Vector3d& b = mesh.point(mesh.to_vertex_handle(h));
  const Eigen::Vector3d& c = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  return (b - a).cross(c - a).normalized();
}

Section section(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to) {
  return section(mesh, from, to, face_normal(mesh, from.face) + face_normal(mesh, to.face));
}

Section section(const TriangleMesh& mesh, const FacePoint& from, const FacePoint& to,
                const Eigen::Vector3d& normal) {
  const Eigen::Vector3d straight = to.position - from.position;
  const double distance = straight.norm();
  Section shortest{distance, straight / distance, -straight / distance};
  if (from.face == to.face) return shortest;
  const Eigen::Vector3d plane = straight.cross(normal);
  // Over a sharp edge the way may begin backwards: both are tried, the likely one first, and the
  // shorter counts.
  std::array<Crossed, 2> out;
  int count = 0;
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(from.face));
  for (int k = 0; k < 3 && count < 2; ++k, h = mesh.next_halfedge_handle(h)) {
    const Eigen::Vector3d u = mesh.point(mesh.from_vertex_handle(h)) - from.position;
    const Eigen::Vector3d w = mesh.point(mesh.to_vertex_handle(h)) - from.position;
    const double a = plane.dot(u), b = plane.dot(w);
    if ((a < 0.0) == (b < 0.0)) continue;
    out[count++] = {h, a, b, straight.dot(u + a / (a - b) * (w - u))};
  }
  if (count == 2 && out[1].ahead > out[0].ahead) std::swap(out[0], out[1]);
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
