#include "meshknit/surface/refine.h"

#include <queue>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/surface/split_edge.h"

namespace meshknit {
namespace {

using EdgeHandle = OpenMesh::EdgeHandle;
using HalfedgeHandle = OpenMesh::HalfedgeHandle;
using VertexHandle = OpenMesh::VertexHandle;

class Refiner {
 public:
  Refiner(RefinedMesh& refined, double max_edge, RunContext* run)
      : refined_(refined), mesh_(refined.mesh), max_squared_(max_edge * max_edge), run_(run) {}

  void split_long_edges() {
    for (const auto edge : mesh_.edges()) push_if_long(edge);
    // Positions never move, so an edge's length changes only when it is split itself, and the
    // queue never holds a stale one.
    for (int splits = 0; !queue_.empty(); ++splits) {
      if (splits % 4096 == 0) report(run_, 0.0);
      const EdgeHandle edge(-queue_.top().second);
      queue_.pop();
      const VertexHandle middle = split(edge);
      for (const auto half : mesh_.voh_range(middle)) push_if_long(mesh_.edge_handle(half));
    }
  }

  // Comes last: splitting a boundary edge may make new bridges, splitting a bridge makes none,
  // and no new edge of it is longer than the edges round it.
  void split_bridges() {
    const int edges = static_cast<int>(mesh_.n_edges());
    for (int e = 0; e < edges; ++e) {
      const EdgeHandle edge(e);
      const HalfedgeHandle half = mesh_.halfedge_handle(edge, 0);
      if (!mesh_.is_boundary(edge) && mesh_.is_boundary(mesh_.from_vertex_handle(half)) &&
          mesh_.is_boundary(mesh_.to_vertex_handle(half)))
        split(edge);
    }
  }

 private:
  void push_if_long(EdgeHandle edge) {
    const double squared = mesh_.calc_edge_sqr_length(edge);
    // The negated index lets the lower index win among equally long edges.
    if (squared > max_squared_) queue_.push({squared, -edge.idx()});
  }

  VertexHandle split(EdgeHandle edge) {
    const HalfedgeHandle half = mesh_.halfedge_handle(edge, 0);
    const VertexHandle from = mesh_.from_vertex_handle(half), to = mesh_.to_vertex_handle(half);
    const VertexHandle middle = split_edge(mesh_, refined_.source_face, edge,
                                           0.5 * (mesh_.point(from) + mesh_.point(to)));
    refined_.value.push_back(0.5 * (refined_.value[from.idx()] + refined_.value[to.idx()]));
    return middle;
  }

  RefinedMesh& refined_;
  TriangleMesh& mesh_;
  double max_squared_;
  std::priority_queue<std::pair<double, int>> queue_;
  RunContext* run_;
};

}  // namespace

RefinedMesh refine_mesh(const TriangleMesh& mesh, const std::vector<double>& value,
                        double max_edge, RunContext* run) {
  if (value.size() != mesh.n_vertices())
    throw InvalidInput("refine_mesh: one value is needed for every vertex");
  if (!(max_edge > 0.0)) throw InvalidInput("refine_mesh: max_edge must be positive");
  RefinedMesh refined{mesh, value, std::vector<int>(mesh.n_faces())};
  for (std::size_t f = 0; f < refined.source_face.size(); ++f)
    refined.source_face[f] = static_cast<int>(f);
  Refiner refiner(refined, max_edge, run);
  refiner.split_long_edges();
  refiner.split_bridges();
  return refined;
}

}  // namespace meshknit
