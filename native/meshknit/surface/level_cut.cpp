#include "meshknit/surface/level_cut.h"

#include <algorithm>

#include "meshknit/surface/point_distance.h"
#include "meshknit/surface/split_edge.h"

namespace meshknit {
namespace {

// An edge that the line crosses, from its low end.
struct Crossing {
  OpenMesh::EdgeHandle edge;
  OpenMesh::VertexHandle low, high;
  double t;
};

std::vector<Crossing> crossings(const TriangleMesh& mesh, const std::vector<double>& distance,
                                double level) {
  std::vector<Crossing> found;
  for (const auto e : mesh.edges()) {
    const auto half = mesh.halfedge_handle(e, 0);
    OpenMesh::VertexHandle low = mesh.from_vertex_handle(half);
    OpenMesh::VertexHandle high = mesh.to_vertex_handle(half);
    if (distance[low.idx()] > distance[high.idx()]) std::swap(low, high);
    if (!(distance[low.idx()] < level && distance[high.idx()] > level)) continue;
    found.push_back({e, low, high,
                     level_crossing(distance[low.idx()], distance[high.idx()],
                                    mesh.calc_edge_length(e), level)});
  }
  return found;
}

}  // namespace

void cut_along_level(TriangleMesh& mesh, std::vector<FaceOrigin>& origin,
                     std::vector<double>& distance, double level, double snap) {
  for (const Crossing& c : crossings(mesh, distance, level)) {
    if (c.t < snap) distance[c.low.idx()] = level;
    if (c.t > 1.0 - snap) distance[c.high.idx()] = level;
  }
  for (const Crossing& c : crossings(mesh, distance, level)) {
    const Eigen::Vector3d &low = mesh.point(c.low), &high = mesh.point(c.high);
    const Eigen::Vector3d place = low + c.t * (high - low);
    split_edge(mesh, origin, c.edge, place);
    distance.push_back(level);
  }
}

double line_length(const TriangleMesh& mesh, const std::vector<double>& distance,
                   double level) {
  std::vector<int> ends(mesh.n_faces(), 0);
  std::vector<Eigen::Vector3d> first(mesh.n_faces());
  double length = 0.0;
  for (const Crossing& c : crossings(mesh, distance, level)) {
    const Eigen::Vector3d place =
        mesh.point(c.low) + c.t * (mesh.point(c.high) - mesh.point(c.low));
    for (int side = 0; side < 2; ++side) {
      const auto half = mesh.halfedge_handle(c.edge, side);
      if (mesh.is_boundary(half)) continue;
      const int face = mesh.face_handle(half).idx();
      if (ends[face]++ == 0)
        first[face] = place;
      else
        length += (place - first[face]).norm();
    }
  }
  return length;
}

std::vector<int> faces_within(const TriangleMesh& mesh, const std::vector<double>& distance,
                              double level) {
  std::vector<int> within, on_line;
  std::vector<char> is_within(mesh.n_faces(), 0);
  for (const auto f : mesh.faces()) {
    double least = level, most = level;
    for (const auto v : mesh.fv_range(f)) {
      least = std::min(least, distance[v.idx()]);
      most = std::max(most, distance[v.idx()]);
    }
    if (least < level)
      is_within[f.idx()] = 1;
    else if (most == level)
      on_line.push_back(f.idx());
  }
  // A face all on the line would stay as a tooth, or as a crumb that hangs on its corners.
  for (bool changed = true; changed;) {
    changed = false;
    for (const int f : on_line) {
      int beside = 0;
      for (const auto other : mesh.ff_range(OpenMesh::FaceHandle(f)))
        beside += is_within[other.idx()];
      if (beside < 2 || is_within[f]) continue;
      is_within[f] = 1;
      changed = true;
    }
  }
  for (std::size_t f = 0; f < is_within.size(); ++f)
    if (is_within[f]) within.push_back(static_cast<int>(f));
  return within;
}

}  // namespace meshknit
