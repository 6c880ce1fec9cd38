#include "meshknit/remesh/even_edges.h"

#include "meshknit/remesh/add_stitches.h"
#include "meshknit/remesh/relaxation.h"

namespace meshknit {
namespace {

// Parts of the time for the first relaxation and for adding stitches.
constexpr double first_share = 0.4, adding_share = 0.3;

}  // namespace

void even_edges(const TriangleMesh& mesh, const std::vector<double>& time,
                std::vector<int>& faces, KnitGraph& graph,
                const std::function<void(double)>& progress) {
  const auto part = [&](double begin, double share) {
    return [&progress, begin, share](double fraction) {
      if (progress) progress(begin + share * fraction);
    };
  };
  relax_nodes(mesh, time, faces, graph, part(0.0, first_share));

  EditableGraph editable(graph);
  SurfaceSprings points(mesh);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    points.add({faces[i], graph.nodes[i].position});
  const StitchSize size{graph.stitch_width, 2.0 * graph.stitch_height};
  if (add_stitches(editable, points, size, part(first_share, adding_share)) == 0) return;
  std::vector<int> number_of;
  graph = editable.graph(number_of);
  faces.clear();
  for (std::size_t i = 0; i < number_of.size(); ++i) {
    const FacePoint& at = points.point(number_of[i]);
    graph.nodes[i].position = at.position;
    faces.push_back(at.face);
  }
  relax_nodes(mesh, time, faces, graph,
              part(first_share + adding_share, 1.0 - first_share - adding_share));
}

}  // namespace meshknit
