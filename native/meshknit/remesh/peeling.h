#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "meshknit/remesh/acceptance.h"
#include "meshknit/remesh/active_cycle.h"
#include "meshknit/remesh/geodesic_band.h"
#include "meshknit/remesh/linking.h"
#include "meshknit/remesh/remesh.h"
#include "meshknit/remesh/row_heights.h"
#include "meshknit/remesh/slicing.h"
#include "meshknit/remesh/trimming.h"

namespace meshknit {

/// The incremental construction of the paper's section 3.2: slice, sample, accept, link, trim,
/// one step at a time.
class Peeling {
 public:
  Peeling(const Surface& surface, const std::vector<double>& time,
          const RemeshOptions& options);

  bool done() const { return done_; }  ///< the last row is peeled
  double progress() const;             ///< fraction of the surface that is knitted
  void peel_row();
  /// Relaxes and measures the graph.
  /// Requires: done(). Call once. `progress` as in relaxation.h.
  KnitGraph take_graph(const std::function<void(double)>& progress = {});

 private:
  // The next row before it is part of the graph.
  struct Row {
    std::vector<double> place;  // along the next cycle
    std::vector<double> time;
    std::vector<char> single;
    std::vector<NodeRun> runs;  // empty: all accepted
    std::vector<Link> links;
  };

  void start(const Surface& surface, int a, int b);
  /// Nearest place on the active cycle of a place on the next one.
  double foot_of(const NextCycle& next, double place) const;
  std::vector<NodeRun> accept(const NextCycle& next, const Row& row) const;
  void link(const NextCycle& next, const std::vector<double>& images, Row& row) const;
  void keep_turns_apart(Row& row, const NextCycle& next,
                        const std::vector<double>& images) const;
  std::vector<TrimRegion> regions(const NextCycle& next, const Row& row) const;
  std::vector<int> add_row(const NextCycle& next, const Row& row);
  void replace_active(const NextCycle& next, const Row& row, const std::vector<int>& node_of,
                      Cycle cycle);
  ActiveNode active_node(const NextCycle& next, double place, int node) const;

  RemeshOptions options_;
  double row_height_;
  PeelState state_;
  std::vector<char> last_;          // vertices of the boundary where knitting ends
  std::vector<int> piece_of_edge_;  // scratch of place_nodes
  std::unique_ptr<GeodesicBand> band_;
  std::unique_ptr<Slicer> slicer_;
  std::unique_ptr<Trimmer> trimmer_;
  std::unique_ptr<RowHeights> heights_;
  ActiveCycle active_;
  KnitGraph graph_;
  std::vector<int> face_of_node_;
  int knitted_ = 0;
  bool done_ = false;
};

}  // namespace meshknit
