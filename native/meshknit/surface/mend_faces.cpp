#include "meshknit/surface/mend_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "meshknit/surface/doubled_vertices.h"
#include "meshknit/surface/surface_problems.h"

namespace meshknit {
namespace {

constexpr double kDoubledTolerance = 1e-6;  // of the bounding box's diagonal
constexpr double kFlatTolerance = 1e-9;     // of the longest side

std::vector<bool> used_vertices(const VertexArray& vertices, const FaceList& faces) {
  std::vector<bool> used(static_cast<std::size_t>(vertices.rows()), false);
  for (const auto& corners : faces.corners)
    for (const int v : corners) used[v] = true;
  return used;
}

void append(std::vector<int>& list, const std::vector<int>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

MendedFaces mend_faces(const VertexArray& vertices, FaceList faces) {
  MendedFaces mended;
  mended.faces = std::move(faces);
  mended.representative.resize(static_cast<std::size_t>(vertices.rows()));
  std::iota(mended.representative.begin(), mended.representative.end(), 0);
  if (mended.faces.corners.empty()) {
    mended.problems.push_back(empty_mesh());
    return mended;
  }

  const std::vector<bool> used = used_vertices(vertices, mended.faces);
  std::vector<int> unused, not_finite;
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < used.size(); ++v) {
    const Eigen::Vector3d point = vertices.row(static_cast<Eigen::Index>(v));
    if (!used[v])
      unused.push_back(static_cast<int>(v));
    else if (!point.allFinite())
      not_finite.push_back(static_cast<int>(v));
    else
      box.extend(point);
  }
  if (!unused.empty()) mended.problems.push_back(unused_vertices(unused));
  if (!not_finite.empty()) {
    mended.problems.push_back(not_finite_vertices(not_finite));
    return mended;
  }

  std::vector<int> collapsed = remove_collapsed_faces(mended.faces);
  std::vector<int> repeated = remove_repeated_faces(mended.faces);
  mended.representative =
      join_doubled_vertices(vertices, mended.faces, kDoubledTolerance * box.diagonal().norm());
  std::vector<int> doubled;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (mended.representative[v] != static_cast<int>(v)) doubled.push_back(static_cast<int>(v));
  for (auto& corners : mended.faces.corners)
    for (int& v : corners) v = mended.representative[v];
  append(collapsed, remove_collapsed_faces(mended.faces));
  append(repeated, remove_repeated_faces(mended.faces));

  if (!collapsed.empty()) mended.problems.push_back(collapsed_faces(std::move(collapsed)));
  if (!repeated.empty()) mended.problems.push_back(repeated_faces(std::move(repeated)));
  if (!doubled.empty()) mended.problems.push_back(doubled_vertices(doubled));
  if (mended.faces.corners.empty()) mended.problems.push_back(empty_mesh());
  return mended;
}

std::vector<int> zero_area_faces(const VertexArray& vertices, const FaceList& faces) {
  std::vector<int> flat;
  for (std::size_t f = 0; f < faces.corners.size(); ++f) {
    const auto& c = faces.corners[f];
    const Eigen::Vector3d a = vertices.row(c[0]), b = vertices.row(c[1]),
                          d = vertices.row(c[2]);
    const double longest =
        std::max({(b - a).squaredNorm(), (d - b).squaredNorm(), (a - d).squaredNorm()});
    if (!((b - a).cross(d - a).norm() > kFlatTolerance * longest))
      flat.push_back(static_cast<int>(f));
  }
  return flat;
}

}  // namespace meshknit
