#include "meshknit/surface/even_triangles.h"

#include <cmath>

namespace meshknit {
namespace {

using Eigen::Vector3d;
using Vertex = OpenMesh::VertexHandle;
using Edge = OpenMesh::EdgeHandle;
using Halfedge = OpenMesh::HalfedgeHandle;

constexpr int rounds = 6;
// Faces may lean away from the smooth surface by less than about 70 degrees; what leans more is
// about to fold over.
constexpr double least_lean = 0.3;
// In a tight crease any face leans; a sliver there is worse than a face that leans more.
constexpr double sliver = 0.4;  // of the edge length

class Evening {
 public:
  Evening(TriangleMesh& mesh, std::vector<int>& rim, const SmoothSurface& surface,
          double edge_length)
      : mesh_(mesh),
        rim_(rim),
        surface_(surface),
        longest_(edge_length * 4.0 / 3.0),
        shortest_(edge_length * 4.0 / 5.0),
        sliver_(edge_length * sliver) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_halfedge_status();
    mesh_.request_face_status();
    mesh_.add_property(number_);
    for (const Vertex v : mesh_.vertices()) mesh_.property(number_, v) = rim_[v.idx()];
  }

  void run() {
    for (int round = 0; round < rounds; ++round) {
      split_long_edges();
      collapse_edges_below(shortest_);
      flip_edges();
      centre_vertices();
    }
    flip_edges();
    // What moving and flipping left too short has no later round to go.
    collapse_edges_below(sliver_);
    rim_.resize(mesh_.n_vertices());
    for (const Vertex v : mesh_.vertices()) rim_[v.idx()] = mesh_.property(number_, v);
    mesh_.remove_property(number_);
    mesh_.release_vertex_status();
    mesh_.release_edge_status();
    mesh_.release_halfedge_status();
    mesh_.release_face_status();
  }

 private:
  int number(Vertex v) const { return mesh_.property(number_, v); }

  void split_long_edges() {
    const auto edges = static_cast<int>(mesh_.n_edges());
    for (int e = 0; e < edges; ++e) {
      const Edge edge(e);
      if (mesh_.calc_edge_length(edge) <= longest_) continue;
      const int rim = mesh_.is_boundary(edge)
                          ? number(mesh_.to_vertex_handle(mesh_.halfedge_handle(edge, 0)))
                          : -1;
      const Vertex added =
          mesh_.add_vertex(surface_.settle(mesh_.calc_edge_midpoint(edge), rim));
      mesh_.property(number_, added) = rim;
      mesh_.split(edge, added);
    }
  }

  void collapse_edges_below(double length) {
    const auto edges = static_cast<int>(mesh_.n_edges());
    for (int e = 0; e < edges; ++e) {
      const Edge edge(e);
      if (mesh_.status(edge).deleted() || mesh_.calc_edge_length(edge) >= length) continue;
      for (int side = 0; side < 2; ++side) {
        const Halfedge half = mesh_.halfedge_handle(edge, side);
        if (!may_collapse(half)) continue;
        mesh_.collapse(half);
        break;
      }
    }
    mesh_.garbage_collection();
  }

  // Whether the vertex that a half edge leaves may move to the one that it points to.
  bool may_collapse(Halfedge half) const {
    const Vertex from = mesh_.from_vertex_handle(half), to = mesh_.to_vertex_handle(half);
    if (number(from) >= 0 &&
        (number(to) != number(from) || !mesh_.is_boundary(mesh_.edge_handle(half))))
      return false;
    if (!mesh_.is_collapse_ok(half)) return false;
    const Vector3d target = mesh_.point(to), normal = surface_.normal(target);
    const double lean = (mesh_.point(from) - target).norm() < sliver_ ? 0.0 : least_lean;
    for (const Vertex v : mesh_.vv_range(from))
      if ((mesh_.point(v) - target).norm() > longest_) return false;
    for (const Halfedge out : mesh_.voh_range(from)) {
      if (mesh_.is_boundary(out)) continue;
      const Vertex a = mesh_.to_vertex_handle(out);
      const Vertex b = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(out));
      if (a != to && b != to &&
          !faces_out(target, mesh_.point(a), mesh_.point(b), normal, lean))
        return false;
    }
    return true;
  }

  // Whether a triangle faces out, given the surface's normal near it.
  static bool faces_out(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                        const Vector3d& out, double lean = least_lean) {
    const Vector3d normal = (b - a).cross(c - a);
    return normal.dot(out) > lean * normal.norm();
  }

  // One pass is enough in a round: vertices move afterwards anyway.
  void flip_edges() {
    for (const Edge edge : mesh_.edges()) {
      if (mesh_.is_boundary(edge) || !mesh_.is_flip_ok(edge)) continue;
      const Halfedge h = mesh_.halfedge_handle(edge, 0), o = mesh_.halfedge_handle(edge, 1);
      const Vector3d a = mesh_.point(mesh_.to_vertex_handle(o));
      const Vector3d b = mesh_.point(mesh_.to_vertex_handle(h));
      const Vector3d c = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)));
      const Vector3d d = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(o)));
      if (angle(c, a, b) + angle(d, a, b) <= angle(a, c, d) + angle(b, c, d) + 1e-9) continue;
      const Vector3d normal = surface_.normal((a + b) / 2.0);
      if (faces_out(c, a, d, normal) && faces_out(c, d, b, normal)) mesh_.flip(edge);
    }
  }

  // The angle at a corner of a triangle.
  static double angle(const Vector3d& at, const Vector3d& p, const Vector3d& q) {
    return std::atan2((p - at).cross(q - at).norm(), (p - at).dot(q - at));
  }

  void centre_vertices() {
    std::vector<Vector3d> wanted(mesh_.n_vertices());
    for (const Vertex v : mesh_.vertices()) {
      Vector3d sum = Vector3d::Zero();
      int count = 0;
      for (const Halfedge out : mesh_.voh_range(v)) {
        if (number(v) >= 0 && !mesh_.is_boundary(mesh_.edge_handle(out))) continue;
        sum += mesh_.point(mesh_.to_vertex_handle(out));
        ++count;
      }
      wanted[v.idx()] = sum / count;
    }
    for (const Vertex v : mesh_.vertices()) {
      const Vector3d point = mesh_.point(v), normal = surface_.normal(point);
      Vector3d step = wanted[v.idx()] - point;
      step -= step.dot(normal) * normal;
      const Vector3d moved = surface_.settle(point + step, number(v));
      // A vertex stays where moving it would turn a face over.
      const Vector3d out_there = surface_.normal(moved);
      bool fine = true;
      for (const Halfedge out : mesh_.voh_range(v)) {
        if (mesh_.is_boundary(out)) continue;
        const Vector3d a = mesh_.point(mesh_.to_vertex_handle(out));
        const Vector3d b = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(out)));
        fine = fine && faces_out(moved, a, b, out_there);
      }
      if (fine) mesh_.set_point(v, moved);
    }
  }

  TriangleMesh& mesh_;
  std::vector<int>& rim_;
  const SmoothSurface& surface_;
  double longest_, shortest_, sliver_;
  OpenMesh::VPropHandleT<int> number_;
};

}  // namespace

void even_triangles(TriangleMesh& mesh, std::vector<int>& rim, const SmoothSurface& surface,
                    double edge_length) {
  Evening(mesh, rim, surface, edge_length).run();
}

}  // namespace meshknit
