#include "meshknit/verify/yarn_paths.h"

#include <algorithm>
#include <string>

namespace meshknit {
namespace {

bool on_both_sides(const TubeOrder& order, int index) {
  const auto spans = [&](Bed bed) {
    return order.is_on(bed) && order.needle(order.leftmost(bed)).index < index &&
           order.needle(order.rightmost(bed)).index > index;
  };
  return spans(Bed::front) && spans(Bed::back);
}

}  // namespace

void YarnPaths::made(int loop, const std::vector<int>& column_of) {
  check_way(loop, column_of);
  const int yarn = fabric_.loops[loop].yarn;
  if (yarn != last_yarn_) check_waiting(loop, column_of);
  if (last_of_[yarn] < 0) in_.push_back(yarn);
  last_of_[yarn] = loop;
  last_yarn_ = yarn;
}

void YarnPaths::check_way(int loop, const std::vector<int>& column_of) {
  if (tubes_.held_tubes().size() < 2) return;
  const int previous = fabric_.loops[loop].previous;
  if (previous < 0) return;
  const int tube = tubes_.tube_of(column_of[loop]);
  const int from = column_of[previous];
  const bool hangs = from >= 0 && tubes_.is_held(from);
  const int tube_from = hangs ? tubes_.tube_of(from) : -1;
  if (tube_from == tube) return;  // tubes are clear of each other, so all lines within one are
  const Needle start = hangs ? tubes_.needle(from) : fabric_.loops[previous].hangs_on;
  const Needle end = fabric_.loops[loop].made_on;
  for (const int other : tubes_.held_tubes()) {
    if (other == tube || other == tube_from || !tubes_.lies_between(other, start, end))
      continue;
    log_.error("yarn-through-tube", fabric_.loops[loop].line,
               "the yarn from " + to_string(start) + " to " + to_string(end) +
                   " runs through another tube and would close it",
               {named_stitch(fabric_.loops[previous]), named_stitch(fabric_.loops[loop])});
  }
}

void YarnPaths::check_waiting(int loop, const std::vector<int>& column_of) {
  const int tube = tubes_.tube_of(column_of[loop]);
  const int line = fabric_.loops[loop].line;
  in_.erase(std::remove_if(in_.begin(), in_.end(),
                           [&](int yarn) {
                             const int out = fabric_.yarns[yarn].line_out;
                             return out > 0 && out < line;
                           }),
            in_.end());
  for (const int yarn : in_) {
    const int column = column_of[last_of_[yarn]];
    if (yarn == fabric_.loops[loop].yarn || !tubes_.is_held(column)) continue;
    if (tubes_.tube_of(column) == tube) continue;
    if (!on_both_sides(tubes_.order(tube), tubes_.needle(column).index)) continue;
    log_.warning("carrier-inside-tube", line,
                 "carrier " + fabric_.yarns[yarn].carrier + " waits at " +
                     to_string(tubes_.needle(column)) +
                     " inside the tube that is knit here, and its yarn with it");
  }
}

}  // namespace meshknit
