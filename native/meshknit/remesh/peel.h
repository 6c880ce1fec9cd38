#pragma once

#include <vector>

#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/graph_builder.h"
#include "meshknit/remesh/knit_limits.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/remesh/slicing.h"
#include "meshknit/remesh/sweep_plan.h"
#include "meshknit/remesh/trimming.h"

namespace meshknit {

/// The nodes of the shortest closed row: fewer do not hang on two beds as a tube.
inline constexpr int fewest_round = 4;

/// What all steps of peeling share: the surface, the plan, the graph, and tools that keep their
/// scratch memory between rows.
struct Peel {
  /// `apart`: as in plan_sweep.
  /// Throws: Cancelled.
  Peel(const Surface& surface, const std::vector<double>& time, const RemeshOptions& options,
       const std::vector<int>& apart, RunContext* run);
  Peel(const Peel&) = delete;
  Peel& operator=(const Peel&) = delete;

  RemeshOptions options;
  double row_height;
  std::vector<int> source_face;  ///< fine face -> row of the input's faces
  PeelState state;
  SweepPlan plan;
  KnitLimits limits;
  GeodesicBand band;
  Slicer slicer;
  Trimmer trimmer;
  GraphBuilder builder;
  std::vector<int> piece_of_edge;  ///< scratch of place_nodes
  int knitted = 0;                 ///< vertices
  std::vector<Trimmer::Pocket> left_out;

  /// Faces of the input near an open vertex, for problems to name.
  std::vector<int> faces_near(int vertex) const;
};

}  // namespace meshknit
