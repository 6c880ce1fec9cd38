#pragma once

#include <vector>

namespace meshknit {

/// What happens to the tubes on the bed.
struct TubeEvent {
  enum class Kind { start, split, merge, end } kind = Kind::start;
  int tube = 0;  ///< that starts, that parts, that others become, that ends
};

/// Which tubes a tube takes over, and which take it over, as they hang from one side to the other;
/// when it begins and ends.
struct TubeLinks {
  std::vector<int> below, above;
  double begin = 0.0, end = 0.0;
};

/// The tubes that hang on the bed, left to right.
using TubesOnBed = std::vector<int>;

/// All events of these tubes, earliest first.
std::vector<TubeEvent> events_in_time(const std::vector<TubeLinks>& tubes);

/// All orders on the bed that an event can leave; none if its tubes do not hang, or not side by side.
std::vector<TubesOnBed> rows_after(const std::vector<TubeLinks>& tubes, const TubesOnBed& row,
                                   const TubeEvent& event);

}  // namespace meshknit
