#include "meshknit/time_field/intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshknit {
namespace {

// Slack of the triangle inequality that thin triangles are given, of the mean side.
constexpr double kInequalitySlack = 1e-8;
// Angle sums this little above pi are left alone; flipping them back and forth would not end.
constexpr double kAngleTolerance = 1e-10;

// Heron's formula in Kahan's order, which keeps thin triangles exact to rounding.
double doubled_area(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return 0.5 * std::sqrt(std::max(product, 0.0));
}

// Adds one small length to every side, so that no triangle is flatter than rounding can bear;
// it changes all lengths alike, hence no angle noticeably but those of the flattest triangles.
void relieve_thin_triangles(IntrinsicTriangles& triangles) {
  double sum = 0.0, worst = -std::numeric_limits<double>::infinity();
  for (const auto& l : triangles.lengths) {
    const double total = l[0] + l[1] + l[2];
    sum += total;
    worst = std::max(worst, 2.0 * std::max({l[0], l[1], l[2]}) - total);
  }
  const double mean = sum / (3.0 * static_cast<double>(triangles.lengths.size()));
  const double extra = std::max(0.0, worst + kInequalitySlack * mean);
  for (auto& l : triangles.lengths)
    for (double& side : l) side += extra;
}

int next_side(int h) { return h % 3 == 2 ? h - 2 : h + 1; }

// Half edge 3 f + k is side k of triangle f.
class Flipper {
 public:
  Flipper(const TriangleMesh& mesh, IntrinsicTriangles& triangles)
      : triangles_(triangles), twin_(3 * mesh.n_faces(), -1) {
    std::vector<int> side_of(mesh.n_halfedges(), -1);
    for (const auto f : mesh.faces()) {
      int side = 3 * f.idx();
      for (const auto half : mesh.fh_range(f)) side_of[half.idx()] = side++;
    }
    for (const auto half : mesh.halfedges())
      if (side_of[half.idx()] >= 0)
        twin_[side_of[half.idx()]] = side_of[mesh.opposite_halfedge_handle(half).idx()];
  }

  void run() {
    std::vector<int> stack;
    for (std::size_t h = twin_.size(); h-- > 0;) stack.push_back(static_cast<int>(h));
    // The number of flips is finite in exact arithmetic; the bound only guards against
    // rounding, and a triangulation that is not quite Delaunay is still a good one.
    std::size_t flips_left = 100 * twin_.size();
    while (!stack.empty() && flips_left > 0) {
      const int h = stack.back();
      stack.pop_back();
      if (twin_[h] < 0 || twin_[h] / 3 == h / 3 || is_delaunay(h)) continue;
      flip(h);
      --flips_left;
      const int f = h / 3, g = twin_[3 * f + 2] / 3;
      for (const int outer : {3 * f, 3 * f + 1, 3 * g, 3 * g + 1}) stack.push_back(outer);
    }
  }

 private:
  double length(int h) const { return triangles_.lengths[h / 3][h % 3]; }

  // The sine of the sum of both opposite angles: negative when they sum to more than pi. Unlike
  // a sum of cotangents it stays finite however thin the triangles are.
  bool is_delaunay(int h) const {
    double sine[2], cosine[2];
    for (int i = 0; i < 2; ++i) {
      const int side = i == 0 ? h : twin_[h];
      const double a = length(side), b = length(next_side(side)),
                   c = length(next_side(next_side(side)));
      sine[i] = doubled_area(a, b, c) / (b * c);
      cosine[i] = (b * b + c * c - a * a) / (2.0 * b * c);
    }
    return sine[0] * cosine[1] + cosine[0] * sine[1] >= -kAngleTolerance;
  }

  // Lays both triangles out in the plane, the common side from (0, 0) to (a, 0).
  double flipped_length(int h) const {
    const int t = twin_[h];
    const double a = length(h);
    const auto apex = [&](double from_start, double to_end) -> std::array<double, 2> {
      return {(a * a + from_start * from_start - to_end * to_end) / (2.0 * a),
              doubled_area(a, from_start, to_end) / a};
    };
    const auto above = apex(length(next_side(next_side(h))), length(next_side(h)));
    const auto below = apex(length(next_side(t)), length(next_side(next_side(t))));
    return std::hypot(above[0] - below[0], above[1] + below[1]);
  }

  //        k                k
  //      /   \            / | \          f: i j k  ->  k i l
  //     i --h- j   ->    i  |  j         g: j i l  ->  l j k
  //      \   /            \ | /          the new diagonal is side 2 of both
  //        l                l
  void flip(int h) {
    const int t = twin_[h], f = h / 3, g = t / 3;
    const double diagonal = flipped_length(h);
    const int jk = next_side(h), ki = next_side(jk), il = next_side(t), lj = next_side(il);
    const std::array<int, 4> before = {ki, il, lj, jk},
                             after = {3 * f, 3 * f + 1, 3 * g, 3 * g + 1};
    const int i = corner(h), j = corner(t), k = corner(ki), l = corner(lj);
    std::array<int, 4> twins{};
    std::array<double, 4> lengths{};
    for (int m = 0; m < 4; ++m) {
      lengths[m] = length(before[m]);
      // An outer side may be glued to another of the four, which moves as well.
      const auto moved = std::find(before.begin(), before.end(), twin_[before[m]]);
      twins[m] = moved == before.end() ? twin_[before[m]] : after[moved - before.begin()];
    }
    triangles_.corners[f] = {k, i, l};
    triangles_.corners[g] = {l, j, k};
    triangles_.lengths[f] = {lengths[0], lengths[1], diagonal};
    triangles_.lengths[g] = {lengths[2], lengths[3], diagonal};
    for (int m = 0; m < 4; ++m) {
      twin_[after[m]] = twins[m];
      if (twins[m] >= 0) twin_[twins[m]] = after[m];
    }
    twin_[3 * f + 2] = 3 * g + 2;
    twin_[3 * g + 2] = 3 * f + 2;
  }

  int corner(int h) const { return triangles_.corners[h / 3][h % 3]; }

  IntrinsicTriangles& triangles_;
  std::vector<int> twin_;  // -1 on the boundary
};

}  // namespace

IntrinsicTriangles side_lengths(const TriangleMesh& mesh) {
  IntrinsicTriangles triangles;
  triangles.corners.resize(mesh.n_faces());
  triangles.lengths.resize(mesh.n_faces());
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto half : mesh.fh_range(f)) {
      triangles.corners[f.idx()][k] = mesh.from_vertex_handle(half).idx();
      triangles.lengths[f.idx()][k] = mesh.calc_edge_length(half);
      ++k;
    }
  }
  if (!triangles.corners.empty()) relieve_thin_triangles(triangles);
  return triangles;
}

IntrinsicTriangles intrinsic_delaunay(const TriangleMesh& mesh) {
  IntrinsicTriangles triangles = side_lengths(mesh);
  Flipper(mesh, triangles).run();
  return triangles;
}

double cotangent_opposite(const std::array<double, 3>& lengths, int k) {
  const double a = lengths[k], b = lengths[(k + 1) % 3], c = lengths[(k + 2) % 3];
  // A triangle that rounding made flat: as steep as numbers go, but finite.
  const double area = std::max(doubled_area(a, b, c), 1e-12 * std::max({a * a, b * b, c * c}));
  return (b * b + c * c - a * a) / (2.0 * area);
}

}  // namespace meshknit
