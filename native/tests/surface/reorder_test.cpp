#include "meshknit/surface/reorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "meshknit/surface/example_shapes.h"
#include "meshknit/surface/surface.h"

namespace meshknit {
namespace {

using Corner = std::array<double, 3>;

// Faces as sets of corner positions, each beginning at its smallest: independent of numbering.
std::multiset<std::array<Corner, 3>> faces_of(const TriangleMesh& mesh) {
  std::multiset<std::array<Corner, 3>> faces;
  for (const auto f : mesh.faces()) {
    std::array<Corner, 3> face;
    int k = 0;
    for (const auto v : mesh.fv_range(f)) {
      const Eigen::Vector3d& p = mesh.point(v);
      face[k++] = {p.x(), p.y(), p.z()};
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

TEST(Reorder, KeepsTheSurfaceAndSortsItByValue) {
  const ExampleShape shape = bent_tube();
  const Surface surface = make_surface(shape.vertices, shape.faces);
  std::vector<double> height;
  for (const auto v : surface.mesh.vertices()) height.push_back(surface.mesh.point(v).z());
  const RefinedMesh before = refine_mesh(surface.mesh, height, 4.0);
  RefinedMesh after = before;
  const std::vector<int> number = reorder_by_value(after);

  EXPECT_TRUE(std::is_sorted(after.value.begin(), after.value.end()));
  for (const auto v : before.mesh.vertices()) {
    const TriangleMesh::VertexHandle moved(number[v.idx()]);
    EXPECT_EQ(before.mesh.point(v), after.mesh.point(moved));
    EXPECT_EQ(before.value[v.idx()], after.value[moved.idx()]);
  }
  EXPECT_EQ(faces_of(before.mesh), faces_of(after.mesh)) << "no face lost, made or turned";
}

}  // namespace
}  // namespace meshknit
