#pragma once

#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/time_field/reeb_graph.h"

namespace meshknit {

/// Who knits what: the surface divided by the Reeb graph of its time field into tubes (arcs) and
/// junctions (saddles), which are peeled one after another. A tube is knit up to the level of the
/// saddle at its end, but keeps half a row clear of the saddle itself; the junction's rows then
/// step over it. So the shape of the graph is that of the field, whatever the rows' geometry does.
struct SweepPlan {
  ReebGraph reeb;

  /// Per vertex: the arc that it belongs to, or event_region(e): the boundary of a start or end, the
  /// near surroundings of a saddle.
  std::vector<int> region;
  /// Per vertex of an arc: distance to the arc's end curve, mm; infinite where that is far.
  std::vector<double> to_end;
  std::vector<std::vector<int>> vertices_of_region;

  std::vector<double> end_level;  ///< per arc: the time of the level set where it ends
  std::vector<char> joined;       ///< per event: several saddles in one (joined_saddles.h)

  int event_region(int event) const { return static_cast<int>(reeb.arcs.size()) + event; }
  int regions() const { return event_region(static_cast<int>(reeb.events.size())); }

  /// How far along an edge a cycle may come that must not reach its far end, as a fraction from
  /// `u`: the end curve of the tube that is knit at `u`.
  double end_fraction(const PeelState& state, int u, int w) const;

  /// Distance from the nearest saddle, mm; infinite where that is far.
  std::vector<double> from_saddle;
  double saddle_radius = 0.0;  ///< mm
};

/// How far before its end the distance of a tube is known: this many rows.
inline constexpr double planned_rows = 40.0;

/// `apart`: fine vertices of saddles that are not to be joined with others.
/// Requires: state.mesh, .time and .edge_length; one time on each boundary.
/// Throws: Cancelled.
SweepPlan plan_sweep(const PeelState& state, double row_height,
                     const std::vector<int>& apart = {}, RunContext* run = nullptr);

}  // namespace meshknit
