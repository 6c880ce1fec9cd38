#include "remesh/exact_distances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "meshknit/remesh/walk.h"

namespace meshknit {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPath =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, CgalMesh>>;

// The faces that a ball of this radius round the cycle reaches are enough: longer ways never
// are the shortest.
constexpr double reach = 12.0;
constexpr double spacing = 0.25;

}  // namespace

std::vector<double> exact_distances(const TimedShape& shape, const PeeledSurface& peeled,
                                    const std::vector<MeshPlace>& places) {
  const TriangleMesh& coarse = shape.surface.mesh;
  std::vector<MeshPlace> sources;
  const Cycle& cycle = peeled.active;
  for (int i = 0; i < cycle.size(); ++i) {
    const auto h = TriangleMesh::HalfedgeHandle(cycle.crossings[i].halfedge);
    const int face =
        peeled.state.mesh.face_handle(peeled.state.mesh.opposite_halfedge_handle(h)).idx();
    const int steps =
        static_cast<int>(std::ceil((cycle.arc[i + 1] - cycle.arc[i]) / spacing)) + 1;
    for (int k = 0; k < steps; ++k)
      sources.push_back({face, cycle.position({i, static_cast<double>(k) / steps})});
  }

  CgalMesh mesh;
  std::map<int, CgalMesh::Vertex_index> vertex;
  std::map<int, CgalMesh::Face_index> face_of;
  for (const auto f : coarse.faces()) {
    // Only the part round the cycle: the method's cost grows with the whole mesh.
    double nearest = 1e9;
    const Eigen::Vector3d centre = coarse.calc_face_centroid(f);
    for (const Eigen::Vector3d& p : cycle.points)
      nearest = std::min(nearest, (p - centre).norm());
    if (nearest > reach) continue;
    std::vector<CgalMesh::Vertex_index> corners;
    for (const auto v : coarse.fv_range(f)) {
      const auto found = vertex.find(v.idx());
      if (found == vertex.end()) {
        const Eigen::Vector3d& p = coarse.point(v);
        vertex[v.idx()] = mesh.add_vertex({p.x(), p.y(), p.z()});
      }
      corners.push_back(vertex[v.idx()]);
    }
    face_of[f.idx()] = mesh.add_face(corners[0], corners[1], corners[2]);
  }

  ShortestPath paths(mesh);
  const auto locate = [&](const MeshPlace& place) {
    const int f = peeled.source_face[place.face];
    const auto face = face_of.at(f);
    // CGAL counts corners from the source of the face's half edge.
    const Eigen::Vector3d weight = corner_weights(coarse, {f, place.position});
    std::map<CgalMesh::Vertex_index, double> weight_of;
    auto h = coarse.halfedge_handle(TriangleMesh::FaceHandle(f));
    for (int k = 0; k < 3; ++k, h = coarse.next_halfedge_handle(h))
      weight_of[vertex[coarse.from_vertex_handle(h).idx()]] = std::max(0.0, weight[k]);
    const auto first = mesh.halfedge(face);
    ShortestPath::Barycentric_coordinates at = {weight_of[mesh.source(first)],
                                                weight_of[mesh.target(first)],
                                                weight_of[mesh.target(mesh.next(first))]};
    return std::make_pair(face, at);
  };
  for (const MeshPlace& source : sources) {
    const auto [face, at] = locate(source);
    paths.add_source_point(face, at);
  }
  std::vector<double> distances;
  for (const MeshPlace& place : places) {
    const auto [face, at] = locate(place);
    distances.push_back(paths.shortest_distance_to_source_points(face, at).first);
  }
  return distances;
}

}  // namespace meshknit
