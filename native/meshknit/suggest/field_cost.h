#pragma once

#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/surface/surface.h"
#include "meshknit/time_field/reeb_graph.h"

namespace meshknit {

/// The gauge and the machine that a field is judged for.
struct CostGauge {
  double stitch_width = 3.66;   ///< l_r, mm
  double stitch_height = 1.73;  ///< l_c, mm
  int needles = 540;            ///< on a bed
};

/// A place where tubes part or meet.
struct SaddlePlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< mm
  double time = 0.0;
  int below = 0, above = 0;  ///< tubes
};

/// What a field makes of its surface, before any row is knit.
struct FieldCost {
  double stitches = 0.0;
  double shaping = 0.0;        ///< increases and decreases that the tubes' girths force
  double short_rows = 0.0;     ///< short rows that uneven steps of time along rows force
  double flat = 0.0;           ///< nodes where time nearly stands still: rows do not reach them
  int splits = 0, merges = 0;  ///< k - 1 for k ways
  int starts = 0, ends = 0;
  int tangled = 0;       ///< saddles where tubes part and meet at once: no row steps over them
  double needles = 0.0;  ///< that the widest rows of all tubes held at once need
  bool can_hang = true;  ///< the tubes have an order on the bed without crossings
  bool fits = true;      ///< on the beds

  std::vector<SaddlePlace> saddles;  ///< by time
  /// Per mesh face: how much slower time steps there than in the middle of its row. From about 1.2
  /// on there will be short rows; above 4 rows do not reach it. 1 where nothing is known.
  std::vector<double> slowness;

  /// Irregular stitches, with a price in them for saddles and for rims to be sewn. Lower is better; what
  /// can_hang or fits forbids, or is tangled, comes after everything else.
  double total() const;
};

/// Judges a field by about a hundred of its level sets, tube by tube of its Reeb graph.
/// Requires: check_time_field without errors.
FieldCost cost_of_field(const Surface& surface, const std::vector<double>& time,
                        const CostGauge& gauge, RunContext* run = nullptr);

}  // namespace meshknit
