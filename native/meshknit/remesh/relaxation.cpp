#include "meshknit/remesh/relaxation.h"

#include "meshknit/remesh/walk.h"

namespace meshknit {
namespace {

// Errors beside shaping reach a few stitches far, so few rounds do most of the work.
constexpr int rounds = 100;

// Each of a node's four springs pulls by this part of its error a round.
constexpr double step = 0.22;

// Movement that goes on from round to round: corrections travel further in fewer rounds.
constexpr double carried_on = 0.7;

// A node that would move less than this stays where it is, mm.
constexpr double still = 2e-3;

// Cosine of the angle between two nodes' triangles from which on the way over the surface is measured:
// bent less, it is at most a hundredth longer than the straight one.
constexpr double hardly_bent = 0.95;

struct Spring {
  int a, b;
  double rest;
};

Eigen::Vector3d normal_of(const TriangleMesh& mesh, int face) {
  return mesh.calc_face_normal(TriangleMesh::FaceHandle(face));
}

}  // namespace

void relax_nodes(const TriangleMesh& mesh, const std::vector<double>& time,
                 std::vector<int>& faces, KnitGraph& graph,
                 const std::function<void(double)>& progress) {
  const std::size_t n = graph.nodes.size();
  std::vector<Spring> springs;
  for (const KnitRow& row : graph.rows)
    for (std::size_t i = 0; i + 1 < row.nodes.size() + row.closed; ++i)
      springs.push_back(
          {row.nodes[i], row.nodes[(i + 1) % row.nodes.size()], graph.stitch_width});
  std::vector<char> has_below(n, 0), has_above(n, 0);
  for (const auto& c : graph.columns) {
    springs.push_back({c[0], c[1], 2.0 * graph.stitch_height});
    has_above[c[0]] = has_below[c[1]] = 1;
  }
  std::vector<Eigen::Vector3d> normal;
  for (const int face : faces) normal.push_back(normal_of(mesh, face));
  std::vector<Eigen::Vector3d> pull(n, Eigen::Vector3d::Zero());
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress(static_cast<double>(round) / rounds);
    for (auto& p : pull) p *= carried_on;
    for (const Spring& s : springs) {
      const Eigen::Vector3d ab = graph.nodes[s.b].position - graph.nodes[s.a].position;
      const double length = ab.norm();
      if (!(length > 0.0)) continue;
      if (normal[s.a].dot(normal[s.b]) < hardly_bent) {
        const Section way = section(mesh, {faces[s.a], graph.nodes[s.a].position},
                                    {faces[s.b], graph.nodes[s.b].position});
        pull[s.a] += step * (way.length - s.rest) * way.from_first;
        pull[s.b] += step * (way.length - s.rest) * way.from_last;
        continue;
      }
      const Eigen::Vector3d force = step * (1.0 - s.rest / length) * ab;
      pull[s.a] += force;
      pull[s.b] -= force;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (!has_below[i] || !has_above[i] || pull[i].squaredNorm() < still * still) continue;
      const FacePoint moved = walk(mesh, {faces[i], graph.nodes[i].position}, pull[i]);
      if (moved.face < 0) continue;  // over a rim: the rows there are the boundaries' own
      if (moved.face != faces[i]) normal[i] = normal_of(mesh, moved.face);
      faces[i] = moved.face;
      graph.nodes[i].position = moved.position;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    // Rounding must not lead beyond the field's range.
    Eigen::Vector3d weight =
        corner_weights(mesh, {faces[i], graph.nodes[i].position}).cwiseMax(0.0);
    weight /= weight.sum();
    auto h = mesh.halfedge_handle(TriangleMesh::FaceHandle(faces[i]));
    double at = 0.0;
    for (int k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h))
      at += weight[k] * time[mesh.from_vertex_handle(h).idx()];
    graph.nodes[i].time = at;
  }
}

}  // namespace meshknit
