#include "meshknit/remesh/graph_builder.h"

namespace meshknit {
namespace {

// The triangle that a cycle's piece after this crossing lies in: the one right of the half edge.
int face_of_piece(const TriangleMesh& mesh, const EdgeCrossing& crossing) {
  return mesh
      .face_handle(
          mesh.opposite_halfedge_handle(TriangleMesh::HalfedgeHandle(crossing.halfedge)))
      .idx();
}

}  // namespace

GraphBuilder::GraphBuilder(const PeelState& state, double stitch_width, double stitch_height)
    : state_(state) {
  graph_.stitch_width = stitch_width;
  graph_.stitch_height = stitch_height;
}

std::vector<int> GraphBuilder::add_rows(const NextCycle& next, const NextRow& row) {
  const int count = static_cast<int>(row.place.size());
  std::vector<int> node_of(count, -1);
  const auto add = [&](const NodeRun& run, bool closed) {
    KnitRow added;
    added.closed = closed;
    const int size = run.size(count);
    for (int k = 0; k < size; ++k) {
      const int j = (run.first + k) % count;
      node_of[j] = static_cast<int>(graph_.nodes.size());
      const CyclePoint p = next.cycle.at(row.place[j]);
      graph_.nodes.push_back({next.cycle.position(p), row.time[j]});
      face_of_node_.push_back(face_of_piece(state_.mesh, next.cycle.crossings[p.piece]));
      added.nodes.push_back(node_of[j]);
    }
    graph_.rows.push_back(std::move(added));
  };
  if (row.runs.empty()) add({0, count - 1}, true);
  for (const NodeRun& run : row.runs) add(run, false);
  return node_of;
}

ActiveNode active_node(const NextCycle& next, double place, int node) {
  const CyclePoint p = next.cycle.at(place);
  ActiveNode added;
  added.node = node;
  added.halfedge = next.cycle.crossings[p.piece].halfedge;
  added.next_halfedge = next.cycle.crossings[(p.piece + 1) % next.cycle.size()].halfedge;
  added.along = p.along;
  added.position = next.cycle.position(p);
  return added;
}

}  // namespace meshknit
