#pragma once

#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// The half edge that a cycle between two sides crosses after this one. `inner(v)` tells the sides
/// apart; half edges lead from the inner to the outer side, and the outer side stays on the left.
/// Requires: inner(from) and not inner(to), and no boundary edge joins the two sides.
template <class Inner>
int next_crossing(const TriangleMesh& mesh, int halfedge, const Inner& inner) {
  const auto back = mesh.opposite_halfedge_handle(TriangleMesh::HalfedgeHandle(halfedge));
  const auto on = mesh.next_halfedge_handle(back);
  // The triangle right of `halfedge` is (outer end, inner end, third vertex).
  return inner(mesh.to_vertex_handle(on).idx()) ? mesh.prev_halfedge_handle(back).idx()
                                                : on.idx();
}

}  // namespace meshknit
