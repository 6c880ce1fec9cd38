#include "meshknit/remesh/walk.h"

#include <Eigen/Geometry>
#include <array>

namespace meshknit {
namespace {

constexpr int most_triangles = 100;

// A walk enters a triangle at an edge: its weight there is zero but for rounding.
constexpr double on_edge = 1e-12;

Eigen::Vector3d weights(const TriangleCorners& c, const Eigen::Vector3d& p) {
  const double squared = c.normal.squaredNorm();
  Eigen::Vector3d w;
  for (int k = 0; k < 3; ++k)
    w[k] = c.normal.dot(
               (c.point[(k + 2) % 3] - c.point[(k + 1) % 3]).cross(p - c.point[(k + 1) % 3])) /
           squared;
  return w;
}

}  // namespace

TriangleCorners triangle_corners(const TriangleMesh& mesh, int face) {
  TriangleCorners c;
  auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(face));
  for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
    c.out[k] = h;
    c.point[k] = mesh.point(mesh.from_vertex_handle(h));
  }
  c.normal = (c.point[1] - c.point[0]).cross(c.point[2] - c.point[0]);
  return c;
}

Eigen::Vector3d corner_weights(const TriangleMesh& mesh, const FacePoint& point) {
  return weights(triangle_corners(mesh, point.face), point.position);
}

FacePoint walk(const TriangleMesh& mesh, const FacePoint& from, const Eigen::Vector3d& by) {
  TriangleCorners corners = triangle_corners(mesh, from.face);
  return walk(mesh, from, by, corners);
}

FacePoint walk(const TriangleMesh& mesh, const FacePoint& from, const Eigen::Vector3d& by,
               TriangleCorners& corners) {
  FacePoint at = from;
  Eigen::Vector3d rest = by;
  int entered = -1;  // half edge of the triangle that the walk came in by
  TriangleCorners c = corners;
  for (int step = 0; step < most_triangles; ++step) {
    if (entered < 0) rest -= c.normal * (rest.dot(c.normal) / c.normal.squaredNorm());
    const Eigen::Vector3d there = weights(c, at.position + rest);
    const auto leaves = [&](int k) {
      return there[k] < -on_edge && c.out[(k + 1) % 3].idx() != entered;
    };
    if (!leaves(0) && !leaves(1) && !leaves(2)) {
      at.position += rest;
      if (entered >= 0) corners = c;
      return at;
    }
    // Weight k falls to zero at the edge opposite corner k, which starts at corner k + 1.
    const Eigen::Vector3d here = weights(c, at.position);
    double least = 1.0;
    int leave = -1;
    for (int k = 0; k < 3; ++k) {
      if (!leaves(k)) continue;
      const double part = here[k] > 0.0 ? here[k] / (here[k] - there[k]) : 0.0;
      if (leave < 0 || part < least) {
        least = part;
        leave = k;
      }
    }
    const auto h = c.out[(leave + 1) % 3];
    const auto back = mesh.opposite_halfedge_handle(h);
    at.position += least * rest;
    if (mesh.is_boundary(back)) return {-1, at.position};
    rest *= 1.0 - least;
    // Turn what is left of the way about the edge into the next triangle's plane.
    const int next = mesh.face_handle(back).idx();
    const TriangleCorners beyond = triangle_corners(mesh, next);
    const Eigen::Vector3d along =
        (c.point[(leave + 2) % 3] - c.point[(leave + 1) % 3]).normalized();
    const Eigen::Vector3d out = along.cross(c.normal).normalized();
    const Eigen::Vector3d on = along.cross(beyond.normal).normalized();
    rest = rest.dot(along) * along + rest.dot(out) * on;
    at.face = next;
    c = beyond;
    entered = back.idx();
  }
  corners = c;
  return at;
}

}  // namespace meshknit
