#include "branching_graphs.h"

#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "graphs.h"

namespace meshknit {
namespace {

using Front = GraphDrawing::Front;

Front part_of(const Front& front, int begin, int end) {
  return {front.begin() + begin, front.begin() + end};
}

Front plain_row(GraphDrawing& drawing, const Front& front) {
  return drawing.closed_row(front, links(static_cast<int>(front.size())));
}

// A row with `growth` increases, or decreases, spread evenly.
std::string shaped_links(int n, int growth) {
  std::string text;
  const int changes = std::abs(growth), taken = growth < 0 ? 2 : 1;
  for (int change = 0, used = 0; change < changes; ++change) {
    const int until = (change + 1) * n / changes - taken;
    text += links(until - used) + (growth < 0 ? "A" : "Y");
    used = until + taken;
  }
  return changes == 0 ? links(n) : text;
}

Front joined(Front a, const Front& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

KnitGraph tube_with_hole(int a, int b, int rows) {
  GraphDrawing drawing;
  const Front trunk = plain_row(drawing, drawing.cast_on(a + b));
  Front left = part_of(trunk, 0, a), right = part_of(trunk, a, a + b);
  for (int row = 0; row < rows; ++row) {
    left = plain_row(drawing, left);
    right = plain_row(drawing, right);
  }
  plain_row(drawing, plain_row(drawing, joined(left, right)));
  return drawing.graph();
}

KnitGraph three_legs(int a, int b, int c, int rows, int growth) {
  GraphDrawing drawing;
  const Front trunk = plain_row(drawing, drawing.cast_on(a + b + c));
  const Front both = plain_row(drawing, part_of(trunk, 0, a + b));
  std::vector<Front> legs{part_of(trunk, a + b, a + b + c), part_of(both, 0, a),
                          part_of(both, a, a + b)};
  for (Front& leg : legs) leg = plain_row(drawing, leg);
  for (int row = 1; row < rows; ++row)
    for (Front& leg : legs)
      leg = drawing.closed_row(leg, shaped_links(static_cast<int>(leg.size()), growth));
  return drawing.graph();
}

KnitGraph three_way_split_beside(int large, int a, int b1, int c, int b2) {
  GraphDrawing drawing;
  const int small = a + b1 + c + b2;
  const Front trunk = plain_row(drawing, drawing.cast_on(large + small));
  Front beside = plain_row(drawing, part_of(trunk, 0, large));
  const Front ring = plain_row(drawing, part_of(trunk, large, large + small));
  const Front middle = joined(part_of(ring, a, a + b1), part_of(ring, a + b1 + c, small));
  plain_row(drawing, middle);
  plain_row(drawing, part_of(ring, 0, a));
  plain_row(drawing, part_of(ring, a + b1, a + b1 + c));
  for (int row = 0; row < 3; ++row) beside = plain_row(drawing, beside);
  return drawing.graph();
}

KnitGraph three_legs_upside_down(int a, int b, int c, int rows) {
  GraphDrawing drawing;
  std::vector<Front> legs{drawing.cast_on(a), drawing.cast_on(b), drawing.cast_on(c)};
  for (int row = 1; row < rows; ++row)
    for (Front& leg : legs) leg = plain_row(drawing, leg);
  const Front both = plain_row(drawing, joined(legs[0], legs[1]));
  legs[2] = plain_row(drawing, legs[2]);
  plain_row(drawing, plain_row(drawing, joined(both, legs[2])));
  return drawing.graph();
}

KnitGraph crossed_pairs(int n, int rows, bool joined_again) {
  GraphDrawing drawing;
  const Front trunk = plain_row(drawing, drawing.cast_on(4 * n));
  std::vector<Front> tubes;
  for (const int half : {0, 1}) {
    const Front part = plain_row(
        drawing, plain_row(drawing, part_of(trunk, 2 * half * n, 2 * (half + 1) * n)));
    for (const int quarter : {0, 1})
      tubes.push_back(plain_row(
          drawing, plain_row(drawing, part_of(part, quarter * n, (quarter + 1) * n))));
  }
  std::vector<Front> pairs;
  for (const int first : {0, 1}) pairs.push_back(joined(tubes[first], tubes[first + 2]));
  for (int row = 0; row < rows; ++row)
    for (Front& pair : pairs) pair = plain_row(drawing, pair);
  if (joined_again) plain_row(drawing, plain_row(drawing, joined(pairs[0], pairs[1])));
  return drawing.graph();
}

KnitGraph arches_over_legs(int arches, int n, int rows) {
  GraphDrawing drawing;
  const int round = 4 * n;
  std::vector<Front> feet;
  for (Front trunk = plain_row(drawing, drawing.cast_on(arches * round));
       static_cast<int>(feet.size()) < arches;) {
    const int left = static_cast<int>(trunk.size()) - round;
    feet.push_back(plain_row(drawing, part_of(trunk, left, left + round)));
    if (left > 0) trunk = plain_row(drawing, part_of(trunk, 0, left));
  }
  std::vector<std::array<Front, 3>> legs;  // the outer two, and the one between them
  for (const Front& foot : feet) {
    const Front above = plain_row(drawing, foot);
    legs.push_back({joined(part_of(above, 3 * n + n / 2, round), part_of(above, 0, n - n / 2)),
                    part_of(above, 2 * n - n / 2, 3 * n - n / 2),
                    joined(part_of(above, n - n / 2, 2 * n - n / 2),
                           part_of(above, 3 * n - n / 2, 3 * n + n / 2))});
  }
  for (const int which : {0, 1, 2})
    for (auto& three : legs) three[which] = plain_row(drawing, three[which]);
  for (int row = 1; row < rows; ++row)
    for (auto& three : legs)
      for (const int which : {0, 1, 2})
        if (which < 2 || row + 1 < rows) three[which] = plain_row(drawing, three[which]);
  for (const auto& three : legs)
    plain_row(drawing, plain_row(drawing, joined(three[0], three[1])));
  return drawing.graph();
}

KnitGraph many_legs(int legs, int n, int rows) {
  GraphDrawing drawing;
  Front trunk = plain_row(drawing, drawing.cast_on(legs * n));
  std::vector<Front> ends;
  for (int left = legs; left > 1; --left) {
    ends.push_back(plain_row(drawing, part_of(trunk, (left - 1) * n, left * n)));
    trunk = plain_row(drawing, part_of(trunk, 0, (left - 1) * n));
  }
  ends.push_back(trunk);
  for (int row = 1; row < rows; ++row)
    for (Front& leg : ends) leg = plain_row(drawing, leg);
  return drawing.graph();
}

}  // namespace meshknit
