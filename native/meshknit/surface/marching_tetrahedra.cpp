#include "meshknit/surface/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// Corners of a cube by number: bit 0 is x, bit 1 is y, bit 2 is z. All tetrahedra go from corner
// 0 to corner 7 by three steps along the axes, so neighbouring cubes cut their common face alike.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                  {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

class Lattice {
 public:
  Lattice(const Blobs& blobs, double spacing) : spacing_(spacing) {
    const BlobBounds box = bounds_of(blobs);
    low_ = box.low.array() - spacing;
    const Vector3d points = ((box.high - low_) / spacing).array().ceil() + 2.0;
    if (!(spacing > 0.0) || !(points.prod() <= 67108864.0))
      throw InvalidInput("the lattice is too fine for the body");
    size_ = points.cast<int>();
    stride_ = {1, size_.x(), size_.x() * size_.y()};
    evaluate(blobs);
  }

  BlobMesh march() {
    crossing_.assign(7 * value_.size(), -1);
    for (int z = 0; z + 1 < size_.z(); ++z)
      for (int y = 0; y + 1 < size_.y(); ++y)
        for (int x = 0; x + 1 < size_.x(); ++x) march_cube(stride_.dot(Vector3i(x, y, z)));
    BlobMesh mesh;
    mesh.vertices =
        Eigen::Map<const VertexArray>(coordinates_.data(), coordinates_.size() / 3, 3);
    mesh.faces = Eigen::Map<const FaceArray>(corners_.data(), corners_.size() / 3, 3);
    return mesh;
  }

 private:
  // A value says that the surface is too far away for any neighbour of the lattice points just
  // ahead to lie on its other side, so those need no value of their own.
  void evaluate(const Blobs& blobs) {
    value_.resize(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z());
    const double neighbour = std::sqrt(3.0);
    for (int z = 0; z < size_.z(); ++z)
      for (int y = 0; y < size_.y(); ++y)
        for (int x = 0; x < size_.x();) {
          const double value =
              distance_outside(blobs, low_ + spacing_ * Vector3d(x, y, z)).value;
          const double clear = std::abs(value) / (steepest_slope * spacing_) - neighbour;
          const int next = x + std::max(1, static_cast<int>(std::min(clear, 1e6)) + 1);
          for (const int end = std::min(next, size_.x()); x < end; ++x)
            value_[stride_.dot(Vector3i(x, y, z))] = value;
        }
  }

  bool inside(int point) const { return value_[point] < 0.0; }
  int corner(int cube, int number) const {
    return cube + stride_.dot(Vector3i(number & 1, number >> 1 & 1, number >> 2));
  }
  Vector3d position(int point) const {
    return low_ + spacing_ * Vector3d(point % size_.x(), point / size_.x() % size_.y(),
                                      point / stride_.z());
  }

  void march_cube(int cube) {
    bool all = true, none = true;
    for (int c = 0; c < 8; ++c) {
      const bool in = inside(corner(cube, c));
      all = all && in;
      none = none && !in;
    }
    if (all || none) return;
    for (const auto& tetrahedron : tetrahedra) march_tetrahedron(cube, tetrahedron);
  }

  void march_tetrahedron(int cube, const int (&tetrahedron)[4]) {
    std::array<int, 4> in{}, out{};  // corners of the cube
    int ins = 0, outs = 0;
    for (const int c : tetrahedron) {
      if (inside(corner(cube, c)))
        in[ins++] = c;
      else
        out[outs++] = c;
    }
    if (ins == 0 || outs == 0) return;
    const Vector3d outward = position(corner(cube, out[0])) - position(corner(cube, in[0]));
    const auto crossing = [&](int i, int o) { return crossing_between(cube, i, o); };
    if (ins == 1) {
      add_face({crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[0], out[2])},
               outward);
    } else if (outs == 1) {
      add_face({crossing(in[0], out[0]), crossing(in[1], out[0]), crossing(in[2], out[0])},
               outward);
    } else {
      const int a = crossing(in[0], out[0]), b = crossing(in[0], out[1]);
      const int c = crossing(in[1], out[1]), d = crossing(in[1], out[0]);
      add_face({a, b, c}, outward);
      add_face({a, c, d}, outward);
    }
  }

  // The vertex on a lattice edge between two corners of a cube, one of which holds all bits of
  // the other.
  int crossing_between(int cube, int i, int o) {
    const int low = std::min(i, o), high = std::max(i, o);
    const int from = corner(cube, low), to = corner(cube, high);
    int& vertex = crossing_[7 * static_cast<std::size_t>(from) + (high - low) - 1];
    if (vertex < 0) {
      vertex = static_cast<int>(coordinates_.size() / 3);
      const double t = std::clamp(value_[from] / (value_[from] - value_[to]), 0.05, 0.95);
      const Vector3d at = position(from) + t * (position(to) - position(from));
      coordinates_.insert(coordinates_.end(), {at.x(), at.y(), at.z()});
    }
    return vertex;
  }

  void add_face(std::array<int, 3> face, const Vector3d& outward) {
    const auto at = [&](int v) { return Vector3d::Map(&coordinates_[3 * v]); };
    const Vector3d p = at(face[0]);
    if ((at(face[1]) - p).cross(at(face[2]) - p).dot(outward) < 0.0)
      std::swap(face[1], face[2]);
    corners_.insert(corners_.end(), face.begin(), face.end());
  }

  double spacing_;
  Vector3d low_;
  Vector3i size_, stride_;
  std::vector<double> value_;
  std::vector<int> crossing_;
  std::vector<double> coordinates_;
  std::vector<int> corners_;
};

}  // namespace

BlobMesh march_tetrahedra(const Blobs& blobs, double spacing) {
  return Lattice(blobs, spacing).march();
}

}  // namespace meshknit
