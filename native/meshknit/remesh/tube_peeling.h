#pragma once

#include <optional>
#include <vector>

#include "meshknit/remesh/peel.h"
#include "meshknit/remesh/sampling.h"
#include "meshknit/remesh/tube_end.h"

namespace meshknit {

/// The incremental construction of the paper's section 3.2 on one tube: slice, sample, accept,
/// link, trim, one row at a time, from its first cycle to its end.
class TubePeeling {
 public:
  /// `active`: the first row of the tube, all of it. `fewest`: least nodes of its closed rows.
  TubePeeling(Peel& peel, int arc, ActiveCycle active, int fewest);

  /// Limits knitting to this tube; call before its first row.
  void resume();
  /// Peels a row. Returns false when the tube has come to its end: then active() is its last row.
  /// Throws: NotKnittable "splits-here".
  bool peel_row();
  int arc() const { return arc_; }
  ActiveCycle take_active() { return std::move(active_); }

 private:
  struct Candidate {
    RowLevel level;
    NextCycle next;
    std::vector<NodeImage> images;
    NextRow row;
    double lean = 1.0;  ///< mean length of the columns over the row's height
  };

  /// Requires: the band is measured from the active cycle, beyond the level.
  Candidate candidate(const RowLevel& level);
  std::vector<NodeRun> accept(const Candidate& c, int worthwhile) const;
  /// Near the end: a short row where the end is further away than elsewhere, if any is worth it.
  bool even_out(const RestOfTube& rest);
  /// Whether a short row may end right above the end of another.
  enum class Turns { apart, anywhere };
  /// Links, trims and adds the row; false if its runs cannot be knit.
  bool knit(Candidate c, Turns turns = Turns::apart, std::size_t largest_pocket = small_pocket);
  bool knit_runs(const Candidate& c, std::vector<NodeRun> runs, Turns turns = Turns::apart);
  /// Where a whole row would close off a part that is still to be knit: short rows into that part.
  bool knit_into_pocket(const RowLevel& level);
  void knit_last(const RestOfTube& rest);

  /// Columns lean beside shaping: rows stand so much lower that columns are 2 l_c long on average.
  double row_height() const { return peel_.row_height / lean_; }
  double foot_of(const NextCycle& next, double place) const;
  void link(Candidate& c) const;
  void keep_turns_apart(Candidate& c) const;
  std::vector<TrimRegion> regions(const Candidate& c) const;
  void add(const Candidate& c, Cycle cycle);

  Peel& peel_;
  int arc_;
  ActiveCycle active_;
  int fewest_;
  int unit_ = 1;        // closed rows have multiples of this many nodes
  int last_unit_ = 1;   // near the end: tubes that meet in one row lie evenly on both beds
  double lean_ = 1.0;   // of the last rows
  bool whole_ = true;   // the active cycle is one closed row
  bool ended_ = false;  // the last row is knit
};

}  // namespace meshknit
