#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A place where level sets of the time field begin, end, split or merge: a vertex, or neighbouring
/// vertices with one time (with a boundary among them, the opening is taken as filled).
struct ReebEvent {
  double time = 0.0;
  std::vector<int> vertices;      ///< mesh vertices, ascending
  std::vector<int> below, above;  ///< arcs that end and begin here, ascending
  bool has_boundary = false;
  int index = 0;  ///< 1 for a start or an end, -1 for a simple saddle, -k for k saddles in one

  bool is_start() const { return below.empty(); }
  bool is_end() const { return above.empty(); }
};

/// A tube: the closed curves that a level set goes through between two events.
struct ReebArc {
  int from = -1, to = -1;  ///< events
};

/// The Reeb graph of a time field (paper, 3.4; algorithms of the sweep with walked level sets).
struct ReebGraph {
  std::vector<ReebEvent> events;   ///< by time
  std::vector<ReebArc> arcs;       ///< by the time of their first event
  std::vector<int> arc_of_vertex;  ///< -1 for vertices of events
};

/// Sweeps the level sets up through the field. Ties are one place, not broken by index.
/// Requires: a finite time per vertex, one time on each boundary.
/// Throws: Cancelled.
/// Ensures: every arc joins an event to one further on in the list; the indices sum up to 2 - 2g.
ReebGraph reeb_graph(const TriangleMesh& mesh, const std::vector<double>& time,
                     RunContext* run = nullptr);

}  // namespace meshknit
