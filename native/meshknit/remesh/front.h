#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshknit/surface/level_walk.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// Where a cycle crosses a mesh edge: on a half edge that leads from a vertex that is knitted
/// to one that is open, at fraction `t` from its start. Never at a vertex, so every crossed
/// triangle is crossed once.
struct EdgeCrossing {
  int halfedge = -1;
  double t = 0.5;
};

/// A place on a cycle: on the piece that follows crossing `piece`, at fraction `along`.
struct CyclePoint {
  int piece = 0;
  double along = 0.0;
};

/// A closed polyline on the surface, with the open surface on its left. Piece i joins crossing
/// i and i + 1 and lies in one triangle.
struct Cycle {
  std::vector<EdgeCrossing> crossings;
  std::vector<Eigen::Vector3d> points;  ///< of the crossings, mm
  std::vector<double>
      arc;  ///< distance along the cycle from crossing 0; one more than crossings

  int size() const { return static_cast<int>(crossings.size()); }
  double length() const { return arc.back(); }
  CyclePoint at(double distance) const;  ///< any distance; wraps round
  double arc_of(const CyclePoint& p) const {
    return arc[p.piece] + p.along * (arc[p.piece + 1] - arc[p.piece]);
  }
  Eigen::Vector3d position(const CyclePoint& p) const;
  /// A value that is known at the crossings, interpolated.
  double value(const CyclePoint& p, const std::vector<double>& at_crossings) const;
};

/// Distance from a to b going forward round a loop of this length, in [0, length).
double forward(double a, double b, double length);
/// Signed distance from a to b the short way round, in [-length/2, length/2).
double around(double a, double b, double length);

/// The surface while it is being peeled: which vertices are knitted, and where edges from
/// knitted to open vertices are crossed by the active cycle.
struct PeelState {
  TriangleMesh mesh;          ///< fine: no edge is longer than a fraction of a stitch
  std::vector<double> time;   ///< per vertex
  std::vector<char> knitted;  ///< per vertex
  std::vector<double>
      crossing;  ///< per edge, from its knitted end; only meaningful where it is crossed
  std::vector<double> edge_length;  ///< per edge, mm

  int from(int halfedge) const {
    return mesh.from_vertex_handle(TriangleMesh::HalfedgeHandle(halfedge)).idx();
  }
  int to(int halfedge) const {
    return mesh.to_vertex_handle(TriangleMesh::HalfedgeHandle(halfedge)).idx();
  }
  const Eigen::Vector3d& point(int vertex) const {
    return mesh.point(TriangleMesh::VertexHandle(vertex));
  }
  double length(int halfedge) const { return edge_length[halfedge >> 1]; }
};

/// Fills `points` and `arc` from `crossings`.
void measure_cycle(const PeelState& state, Cycle& cycle);

}  // namespace meshknit
