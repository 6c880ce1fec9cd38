#include "meshknit/surface/face_list.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

std::vector<int> remove_marked(FaceList& faces, const std::vector<bool>& marked) {
  std::vector<int> removed;
  FaceList kept;
  for (std::size_t f = 0; f < faces.corners.size(); ++f) {
    if (marked[f]) {
      removed.push_back(faces.source[f]);
    } else {
      kept.corners.push_back(faces.corners[f]);
      kept.source.push_back(faces.source[f]);
    }
  }
  faces = std::move(kept);
  return removed;
}

}  // namespace

FaceList list_faces(const VertexArray& vertices, const FaceArray& faces) {
  FaceList list;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k)
      if (faces(f, k) < 0 || faces(f, k) >= vertices.rows())
        throw InvalidInput("face " + std::to_string(f) + " names vertex " +
                           std::to_string(faces(f, k)) + ", but there are " +
                           std::to_string(vertices.rows()) + " vertices");
    list.corners.push_back({faces(f, 0), faces(f, 1), faces(f, 2)});
    list.source.push_back(static_cast<int>(f));
  }
  return list;
}

std::vector<int> remove_collapsed_faces(FaceList& faces) {
  std::vector<bool> collapsed;
  for (const auto& c : faces.corners)
    collapsed.push_back(c[0] == c[1] || c[1] == c[2] || c[2] == c[0]);
  return remove_marked(faces, collapsed);
}

std::vector<int> remove_repeated_faces(FaceList& faces) {
  std::vector<std::pair<std::array<int, 3>, std::size_t>> keys;
  for (std::size_t f = 0; f < faces.corners.size(); ++f) {
    auto key = faces.corners[f];
    std::sort(key.begin(), key.end());
    keys.push_back({key, f});
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(faces.corners.size(), false);
  for (std::size_t i = 1; i < keys.size(); ++i)
    repeated[keys[i].second] = keys[i].first == keys[i - 1].first;
  return remove_marked(faces, repeated);
}

std::vector<FaceSide> sorted_sides(const FaceList& faces) {
  std::vector<FaceSide> sides;
  sides.reserve(3 * faces.corners.size());
  for (std::size_t f = 0; f < faces.corners.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int from = faces.corners[f][k], to = faces.corners[f][(k + 1) % 3];
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<int>(f), k, from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const FaceSide& x, const FaceSide& y) {
    return std::tie(x.a, x.b, x.face, x.corner) < std::tie(y.a, y.b, y.face, y.corner);
  });
  return sides;
}

}  // namespace meshknit
