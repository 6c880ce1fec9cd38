#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/remesh/peel.h"
#include "meshknit/remesh/tube_peeling.h"

namespace meshknit {

/// The incremental construction of the paper's section 3.2 over the whole surface: tubes are peeled
/// one after another, in the order in which the time field begins them, and joined at saddles.
class Peeling {
 public:
  /// `apart`: fine vertices of saddles that are not to be joined (joined_saddles.h).
  /// Throws: NotKnittable, Cancelled.
  Peeling(const Surface& surface, const std::vector<double>& time, const RemeshOptions& options,
          const std::vector<int>& apart = {}, RunContext* run = nullptr);

  bool done() const { return done_; }
  double progress() const;  ///< fraction of the surface that is knitted
  /// The next row, or the rows at the next start or saddle.
  /// Throws: NotKnittable; NotInOneRow (junction.h): begin again with these saddles apart.
  void step();
  /// What is knit so far: rows and columns, without lengths.
  const KnitGraph& graph() { return peel_.builder.graph(); }
  /// "part-left-out": parts of a dozen stitches and more that no row could reach into.
  Problems warnings() const;
  /// Relaxes (if the options say so) and measures the graph.
  /// Requires: done(). Call once. `progress` as in relaxation.h.
  KnitGraph take_graph(const std::function<void(double)>& progress = {});

 private:
  void begin_event();
  void start(const ReebEvent& event);
  void begin_tube(int arc, ActiveCycle active);
  int fewest_nodes(int arc) const;

  Peel peel_;
  int event_ = 0;                      // the next one
  std::deque<TubePeeling> tubes_;      // under way; the first one is being peeled
  std::vector<ActiveCycle> last_row_;  // per arc, once it is done
  bool done_ = false;
};

}  // namespace meshknit
