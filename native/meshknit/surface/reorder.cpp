#include "meshknit/surface/reorder.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace meshknit {

std::vector<int> reorder_by_value(RefinedMesh& refined, RunContext* run) {
  const TriangleMesh& mesh = refined.mesh;
  std::vector<int> order(mesh.n_vertices()), number(mesh.n_vertices());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return refined.value[a] < refined.value[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<int>(i);

  report(run, 0.0);
  struct Face {
    std::array<int, 3> corners;
    int source;
  };
  std::vector<Face> faces;
  faces.reserve(mesh.n_faces());
  for (const auto f : mesh.faces()) {
    Face face;
    int k = 0;
    for (const auto v : mesh.fv_range(f)) face.corners[k++] = number[v.idx()];
    std::rotate(face.corners.begin(),
                std::min_element(face.corners.begin(), face.corners.end()), face.corners.end());
    face.source = refined.source_face[f.idx()];
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.corners < b.corners; });

  report(run, 0.0);
  RefinedMesh sorted;
  sorted.mesh.reserve(mesh.n_vertices(), mesh.n_edges(), mesh.n_faces());
  for (const int v : order) {
    sorted.mesh.add_vertex(mesh.point(TriangleMesh::VertexHandle(v)));
    sorted.value.push_back(refined.value[v]);
  }
  using V = TriangleMesh::VertexHandle;
  for (const Face& face : faces) {
    if (sorted.source_face.size() % 16384 == 0) report(run, 0.0);
    sorted.mesh.add_face(V(face.corners[0]), V(face.corners[1]), V(face.corners[2]));
    sorted.source_face.push_back(face.source);
  }
  report(run, 0.0);
  refined = std::move(sorted);
  return number;
}

}  // namespace meshknit
