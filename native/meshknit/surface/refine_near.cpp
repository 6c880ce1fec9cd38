#include "meshknit/surface/refine_near.h"

#include <algorithm>

#include "meshknit/surface/split_edge.h"

namespace meshknit {
namespace {

using EdgeHandle = OpenMesh::EdgeHandle;
using FaceHandle = OpenMesh::FaceHandle;

class NearRefiner {
 public:
  NearRefiner(TriangleMesh& mesh, std::vector<FaceOrigin>& origin, const SurfacePoint& place,
              double reach, double max_edge)
      : mesh_(mesh), origin_(origin), place_(place), reach_(reach), max_edge_(max_edge) {}

  void run() {
    mark_wanted();
    // Faces that a split makes have higher numbers, or the number of the face that was split.
    for (int f = 0; f < static_cast<int>(mesh_.n_faces()); ++f)
      while (too_large(f)) split_longest_of(FaceHandle(f));
  }

 private:
  bool in_ball(int face) const {
    const Eigen::Vector3d nearest =
        nearest_in_triangle(corners_of(mesh_, face), place_.position);
    return (nearest - place_.position).norm() <= reach_;
  }

  // Remembered by the faces of the input: pieces of a wanted face are wanted too.
  void mark_wanted() {
    int faces = 0;
    for (const FaceOrigin& origin : origin_) faces = std::max(faces, origin.face + 1);
    wanted_.assign(static_cast<std::size_t>(faces), false);
    std::vector<bool> seen(mesh_.n_faces(), false);
    std::vector<int> front{place_.face};
    seen[place_.face] = true;
    while (!front.empty()) {
      const int face = front.back();
      front.pop_back();
      wanted_[origin_[face].face] = true;
      for (const auto other : mesh_.ff_range(FaceHandle(face))) {
        if (seen[other.idx()] || !in_ball(other.idx())) continue;
        seen[other.idx()] = true;
        front.push_back(other.idx());
      }
    }
  }

  EdgeHandle longest_edge(FaceHandle face) const {
    EdgeHandle longest;
    double length = -1.0;
    for (const auto e : mesh_.fe_range(face)) {
      const double l = mesh_.calc_edge_sqr_length(e);
      // The lower number among equals: two faces then agree about the edge between them.
      if (l > length || (l == length && e.idx() < longest.idx())) {
        length = l;
        longest = e;
      }
    }
    return longest;
  }

  bool too_large(int face) const {
    return wanted_[origin_[face].face] &&
           mesh_.calc_edge_length(longest_edge(FaceHandle(face))) > max_edge_ && in_ball(face);
  }

  // Follows the longest edges outwards until two faces share theirs (or it is a boundary), and
  // splits that one.
  void split_longest_of(FaceHandle face) {
    for (;;) {
      const EdgeHandle edge = longest_edge(face);
      FaceHandle other;
      for (int side = 0; side < 2; ++side) {
        const auto half = mesh_.halfedge_handle(edge, side);
        if (!mesh_.is_boundary(half) && mesh_.face_handle(half) != face)
          other = mesh_.face_handle(half);
      }
      if (!other.is_valid() || longest_edge(other) == edge) {
        split(edge);
        return;
      }
      face = other;
    }
  }

  void split(EdgeHandle edge) {
    const auto half = mesh_.halfedge_handle(edge, 0);
    const Eigen::Vector3d middle = 0.5 * (mesh_.point(mesh_.from_vertex_handle(half)) +
                                          mesh_.point(mesh_.to_vertex_handle(half)));
    split_edge(mesh_, origin_, edge, middle);
  }

  TriangleMesh& mesh_;
  std::vector<FaceOrigin>& origin_;
  const SurfacePoint place_;
  const double reach_, max_edge_;
  std::vector<bool> wanted_;
};

}  // namespace

void refine_near(TriangleMesh& mesh, std::vector<FaceOrigin>& origin, const SurfacePoint& place,
                 double reach, double max_edge) {
  NearRefiner(mesh, origin, place, reach, max_edge).run();
}

}  // namespace meshknit
