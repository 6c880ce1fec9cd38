#pragma once

#include <vector>

#include "meshknit/surface/surface.h"

namespace meshknit {

/// A time field from any values on a surface: a height, a distance, what a user painted. Every boundary
/// gets one time: the earliest of its values if it is a start (the cloth beside it is later on the
/// whole), else the latest; there is at least one start and one end. All is stretched to [-1, 1]. One value and one time per mesh vertex.
/// Throws: InvalidInput if there is not one finite value a vertex.
/// Ensures: order is kept, but for boundaries. check_time_field may still find extrema: see mend_field.
std::vector<double> field_from_values(const Surface& surface,
                                      const std::vector<double>& values);

/// The geodesic distance from these boundaries (mm) as a time field: rows keep their distance, so
/// there are next to no short rows (paper, Figure 10). Other boundaries have the time of their furthest
/// vertex.
/// Throws: InvalidInput for no boundary, one that is not there, or all of them.
std::vector<double> distance_field(const Surface& surface, const std::vector<int>& starts);

/// `share` of the way from one field to another (0: the first).
/// Throws: InvalidInput for fields of different lengths.
std::vector<double> blended(const std::vector<double>& from, const std::vector<double>& to,
                            double share);

/// A field whose false extrema are gone: pits are filled up to where they overflow, peaks are cut
/// down likewise, no further, and what becomes level rises a little from there on, so that every
/// place has an earlier and a later neighbour (priority flood, Barnes, Lehman and Mulla 2014).
/// Boundaries keep their times.
struct MendedField {
  std::vector<double> time;
  int changed = 0;    ///< vertices
  double most = 0.0;  ///< largest change, as a share of the field's range
};
/// Requires: a finite time per mesh vertex, one on each boundary.
MendedField mend_field(const Surface& surface, const std::vector<double>& time);

}  // namespace meshknit
