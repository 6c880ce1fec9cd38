#include "remesh/exact_distances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "meshknit/remesh/walk.h"

namespace meshknit {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPath =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, CgalMesh>>;

constexpr double farthest = 5.0;
constexpr double spacing = 0.25;

// CGAL 5.5 errs where a point lies on an edge: all move towards the middle of their face by
// this part of the way, less than 0.005 mm.
constexpr double off_edges = 1e-3;

// Points of the cycle, none of them on an edge of the fine mesh.
std::vector<MeshPlace> sample(const PeeledSurface& peeled) {
  std::vector<MeshPlace> samples;
  const Cycle& cycle = peeled.active;
  const TriangleMesh& mesh = peeled.state.mesh;
  for (int i = 0; i < cycle.size(); ++i) {
    const auto h = TriangleMesh::HalfedgeHandle(cycle.crossings[i].halfedge);
    const int face = mesh.face_handle(mesh.opposite_halfedge_handle(h)).idx();
    const int steps = static_cast<int>(std::ceil((cycle.arc[i + 1] - cycle.arc[i]) / spacing));
    for (int k = 0; k < steps; ++k)
      samples.push_back({face, cycle.position({i, (k + 0.5) / steps})});
  }
  return samples;
}

// The coarse faces near a place, for CGAL.
class Neighbourhood {
 public:
  Neighbourhood(const TriangleMesh& coarse, const Eigen::Vector3d& centre) : coarse_(coarse) {
    // A way of `farthest` stays in faces that have a corner within it and an edge more.
    double longest = 0.0;
    for (const auto e : coarse.edges()) longest = std::max(longest, coarse.calc_edge_length(e));
    for (const auto f : coarse.faces()) {
      bool near = false;
      for (const auto v : coarse.fv_range(f))
        near = near || (coarse.point(v) - centre).norm() < farthest + longest;
      if (near) add(f);
    }
  }
  const CgalMesh& mesh() const { return mesh_; }

  ShortestPath::Face_location locate(int face, const Eigen::Vector3d& position) const {
    // CGAL counts corners from the source of its face's half edge.
    const Eigen::Vector3d middle = coarse_.calc_face_centroid(TriangleMesh::FaceHandle(face));
    const Eigen::Vector3d weight =
        corner_weights(coarse_, {face, position + off_edges * (middle - position)});
    std::map<CgalMesh::Vertex_index, double> weight_of;
    auto h = coarse_.halfedge_handle(TriangleMesh::FaceHandle(face));
    for (int k = 0; k < 3; ++k, h = coarse_.next_halfedge_handle(h))
      weight_of[vertex_of_.at(coarse_.from_vertex_handle(h).idx())] = std::max(0.0, weight[k]);
    const auto first = mesh_.halfedge(face_of_.at(face));
    return {face_of_.at(face),
            {weight_of[mesh_.source(first)], weight_of[mesh_.target(first)],
             weight_of[mesh_.target(mesh_.next(first))]}};
  }

 private:
  void add(TriangleMesh::FaceHandle f) {
    std::vector<CgalMesh::Vertex_index> corners;
    for (const auto v : coarse_.fv_range(f)) {
      if (vertex_of_.count(v.idx()) == 0) {
        const Eigen::Vector3d& p = coarse_.point(v);
        vertex_of_[v.idx()] = mesh_.add_vertex({p.x(), p.y(), p.z()});
      }
      corners.push_back(vertex_of_[v.idx()]);
    }
    face_of_[f.idx()] = mesh_.add_face(corners[0], corners[1], corners[2]);
  }

  const TriangleMesh& coarse_;
  CgalMesh mesh_;
  std::map<int, CgalMesh::Vertex_index> vertex_of_;
  std::map<int, CgalMesh::Face_index> face_of_;
};

}  // namespace

std::vector<double> exact_distances(const TimedShape& shape, const PeeledSurface& peeled,
                                    const std::vector<MeshPlace>& places) {
  const std::vector<MeshPlace> samples = sample(peeled);
  std::vector<double> distances;
  for (const MeshPlace& place : places) {
    // One source at a time: with many sources close together CGAL 5.5 misses some of them.
    const Neighbourhood near(shape.surface.mesh, place.position);
    ShortestPath paths(near.mesh());
    const auto source = near.locate(peeled.source_face[place.face], place.position);
    paths.add_source_point(source.first, source.second);
    double least = std::numeric_limits<double>::infinity();
    for (const MeshPlace& point : samples) {
      if ((point.position - place.position).norm() > farthest) continue;
      const auto target = near.locate(peeled.source_face[point.face], point.position);
      const double distance =
          paths.shortest_distance_to_source_points(target.first, target.second).first;
      if (distance >= 0.0) least = std::min(least, distance);
    }
    distances.push_back(least);
  }
  return distances;
}

}  // namespace meshknit
