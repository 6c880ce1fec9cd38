#include "meshknit/surface/rim_cuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

class Cutting {
 public:
  explicit Cutting(const BlobMesh& mesh) {
    for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
      points_.push_back(mesh.vertices.row(v));
    for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
      faces_.push_back({mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2)});
    rim_.assign(points_.size(), -1);
  }

  void cut(const RimCut& cut, int number) {
    find_cap(cut);
    crossing_.clear();
    std::vector<std::array<int, 3>> kept;
    for (const auto& face : faces_) split_face(face, cut, number, kept);
    if (kept.empty()) throw InvalidInput("a rim's plane leaves nothing of the body");
    faces_ = std::move(kept);
  }

  // Vertices that no face uses any more are left out.
  std::vector<int> finish(BlobMesh& mesh) const {
    std::vector<int> place(points_.size(), -1), rim;
    for (const auto& face : faces_)
      for (const int v : face) place[v] = 0;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (place[v] < 0) continue;
      place[v] = static_cast<int>(rim.size());
      rim.push_back(rim_[v]);
    }
    mesh.vertices.resize(static_cast<Eigen::Index>(rim.size()), 3);
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (place[v] >= 0) mesh.vertices.row(place[v]) = points_[v];
    mesh.faces.resize(static_cast<Eigen::Index>(faces_.size()), 3);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (int k = 0; k < 3; ++k)
        mesh.faces(static_cast<Eigen::Index>(f), k) = place[faces_[f][k]];
    return rim;
  }

 private:
  static double beyond(const RimCut& cut, const Vector3d& point) {
    return cut.outward.dot(point - cut.at);
  }

  void find_cap(const RimCut& cut) {
    std::vector<std::vector<int>> neighbours(points_.size());
    for (const auto& face : faces_)
      for (int k = 0; k < 3; ++k) {
        neighbours[face[k]].push_back(face[(k + 1) % 3]);
        neighbours[face[(k + 1) % 3]].push_back(face[k]);
      }
    int first = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const double distance = (points_[v] - cut.at).squaredNorm();
      if (neighbours[v].empty() || !(beyond(cut, points_[v]) > 0.0) || distance >= nearest)
        continue;
      nearest = distance;
      first = static_cast<int>(v);
    }
    if (first < 0) throw InvalidInput("nothing of the body lies beyond a rim's plane");
    in_cap_.assign(points_.size(), false);
    in_cap_[first] = true;
    std::vector<int> open = {first};
    while (!open.empty()) {
      const int v = open.back();
      open.pop_back();
      for (const int w : neighbours[v]) {
        if (in_cap_[w] || !(beyond(cut, points_[w]) > 0.0)) continue;
        in_cap_[w] = true;
        open.push_back(w);
      }
    }
  }

  bool in_cap(int v) const {
    return static_cast<std::size_t>(v) < in_cap_.size() && in_cap_[v];
  }

  // Keeps what is left of a face: all, a triangle, a quadrangle or nothing.
  void split_face(const std::array<int, 3>& face, const RimCut& cut, int number,
                  std::vector<std::array<int, 3>>& kept) {
    std::vector<int> polygon;
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      if (!in_cap(a)) polygon.push_back(a);
      if (in_cap(a) != in_cap(b)) polygon.push_back(crossing(a, b, cut, number));
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      kept.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }

  int crossing(int a, int b, const RimCut& cut, int number) {
    const auto [found, added] =
        crossing_.try_emplace(std::minmax(a, b), static_cast<int>(points_.size()));
    if (added) {
      const double from = beyond(cut, points_[a]), to = beyond(cut, points_[b]);
      // A vertex in the plane must not become two vertices in one place.
      const double t = std::clamp(from / (from - to), 0.05, 0.95);
      points_.push_back(points_[a] + t * (points_[b] - points_[a]));
      rim_.push_back(number);
    }
    return found->second;
  }

  std::vector<Vector3d> points_;
  std::vector<std::array<int, 3>> faces_;
  std::vector<int> rim_;
  std::vector<bool> in_cap_;
  std::map<std::pair<int, int>, int> crossing_;
};

}  // namespace

std::vector<int> cut_rims(BlobMesh& mesh, const std::vector<RimCut>& cuts) {
  Cutting cutting(mesh);
  for (std::size_t i = 0; i < cuts.size(); ++i) cutting.cut(cuts[i], static_cast<int>(i));
  return cutting.finish(mesh);
}

}  // namespace meshknit
