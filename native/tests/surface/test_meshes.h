#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Vertices and faces as a caller of the library hands them in.
struct MeshArrays {
  VertexArray vertices;
  FaceArray faces;
};

/// The project's own generator for tests: the same numbers on every machine.
class Jitter {
 public:
  explicit Jitter(std::uint32_t seed) : state_(seed) {}
  /// In [-1, 1).
  double next();

 private:
  std::uint32_t state_;
};

/// A tube round the z axis: `around` x `along` quads, each cut into two triangles; ring r holds
/// vertices r * around .. (r + 1) * around - 1, ring 0 at z = 0, normals outward.
struct TubeShape {
  int around = 24;
  int along = 12;
  double length = 100.0;                                               ///< mm
  std::function<double(double)> radius = [](double) { return 20.0; };  ///< mm, of the height
  double jitter = 0.0;  ///< inner vertices move along the surface by this fraction of a cell
};
MeshArrays tube(const TubeShape& shape = {});

/// A ring-shaped tube (genus 1): 24 x 12 quads, quad q is faces 2 q and 2 q + 1.
MeshArrays closed_torus();

/// The same cut open along one cross-section: two rims that lie on each other.
MeshArrays cut_torus();

/// Leaves out some quads of a shape that is made of pairs of triangles.
MeshArrays without_quads(const MeshArrays& arrays, const std::vector<int>& quads);

/// A w x h grid of squares of side `cell` in the plane z = 0 (normals +z), without the squares
/// for which `hole(column, row)` holds. Its vertex (column, row) is row * (w + 1) + column.
MeshArrays grid(int w, int h, double cell, const std::function<bool(int, int)>& hole);

/// Two meshes in one, the second moved by `shift`. Nothing is joined.
MeshArrays side_by_side(const MeshArrays& a, const MeshArrays& b, const Eigen::Vector3d& shift);

/// Every triangle with three vertices of its own, as in an STL file.
MeshArrays triangle_soup(const MeshArrays& arrays);

/// A closed ball: an octahedron whose faces were quartered `times` times and pushed out.
MeshArrays ball(double radius, int times = 4);

/// A closed box from (0, 0, 0) to `size`, two triangles a side.
MeshArrays box(const Eigen::Vector3d& size);

/// The half-edge mesh of arrays known to be good.
TriangleMesh half_edges(const MeshArrays& arrays);

}  // namespace meshknit
