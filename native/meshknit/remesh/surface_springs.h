#pragma once

#include <functional>
#include <vector>

#include "meshknit/remesh/section_length.h"
#include "meshknit/remesh/walk.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Pulls two points of a surface to a wanted distance, mm.
struct Spring {
  int a = -1, b = -1;
  double rest = 0.0;
};

/// Points that stay on a surface while springs move them.
class SurfaceSprings {
 public:
  explicit SurfaceSprings(const TriangleMesh& mesh) : mesh_(mesh) {}

  int size() const { return static_cast<int>(points_.size()); }
  void add(const FacePoint& at);
  /// Leaves only the first `size` points.
  void shrink(int size);
  const FacePoint& point(int i) const { return points_[i]; }
  void move(int i, const FacePoint& to);
  /// A point on the way from a to b, this part of its length from a; a itself if a rim lies between.
  FacePoint between(int a, int b, double part) const;

  /// Surface distance; straight where the surface hardly bends on the way.
  double length(int a, int b) const;
  /// (length - rest) / rest.
  double error(const Spring& spring) const {
    return length(spring.a, spring.b) / spring.rest - 1.0;
  }

  /// Moves the `movable` points so that springs come nearer to their length. None leaves the
  /// surface. `progress` is told the fraction that is done and may throw. Many points are moved on
  /// several threads (core/parallel.h), to the places that one would find.
  void relax(const std::vector<Spring>& springs, const std::vector<int>& movable, int rounds,
             const std::function<void(double)>& progress = {});

 private:
  struct Force {
    Eigen::Vector3d on_a, on_b;
  };
  struct Motion {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // of all its springs
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();   // with what is carried on
    bool moved = false;                               // in the last round
  };

  Force force(const Spring& spring) const;
  bool bends(int a, int b) const;
  void pull(int point, double least_move);

  const TriangleMesh& mesh_;
  std::vector<FacePoint> points_;
  std::vector<TriangleCorners> corners_;  // of the points' triangles
  std::vector<Eigen::Vector3d> normals_;  // unit normals of these
  std::vector<Motion> motion_;            // scratch of relax
};

}  // namespace meshknit
