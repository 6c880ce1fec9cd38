#include "meshknit/verify/yarn_slack.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace meshknit {
namespace {

std::string in_needles(int quarters) {
  static const char* const fraction[] = {"", ".25", ".5", ".75"};
  return std::to_string(quarters / kQuarters) + fraction[quarters % kQuarters];
}

}  // namespace

int needle_distance(const Needle& a, const Needle& b, int racking) {
  const auto place = [&](const Needle& needle) {
    return kQuarters * needle.index + (needle.bed == Bed::back ? racking : 0);
  };
  return std::abs(place(a) - place(b));
}

void YarnSlack::made(int loop, int racking) {
  bridge_at_.resize(fabric_.loops.size(), -1);
  Loop& made = fabric_.loops[loop];
  if (made.previous < 0) return;
  const Loop& before = fabric_.loops[made.previous];
  made.made_distance = needle_distance(made.hangs_on, before.hangs_on, racking);
  if (made.made_distance > kQuarters * profile_.max_float) {
    log_.error("float-too-long", made.line,
               "the yarn runs " + in_needles(made.made_distance) + " needles from " +
                   to_string(before.hangs_on) + " to " + to_string(made.hangs_on) +
                   " without a loop; at most " + std::to_string(profile_.max_float) +
                   " are allowed",
               {named_stitch(made), named_stitch(before)});
  }
  watch_bridge(loop);
  check(loop, racking, made.line);
}

void YarnSlack::moved(int loop, int racking, int line) {
  const int following = fabric_.loops[loop].following;
  for (const int pair : {loop, following}) {
    if (pair < 0) continue;
    unwatch_bridge(pair);
    watch_bridge(pair);
    check(pair, racking, line);
  }
}

void YarnSlack::let_go(int loop) {
  unwatch_bridge(loop);
  const int following = fabric_.loops[loop].following;
  // A loop pulled through the one before it on its yarn is being made just now.
  const bool made = following >= 0 && following < static_cast<int>(bridge_at_.size());
  if (made) unwatch_bridge(following);
}

void YarnSlack::racked(int racking, int line) {
  for (const int pair : bridges_) check(pair, racking, line);
}

bool YarnSlack::held(int pair) const {
  const Loop& second = fabric_.loops[pair];
  return second.previous >= 0 && second.fate == Loop::Fate::held &&
         fabric_.loops[second.previous].fate == Loop::Fate::held;
}

void YarnSlack::check(int pair, int racking, int line) {
  if (!held(pair)) return;
  const Loop& second = fabric_.loops[pair];
  const Loop& first = fabric_.loops[second.previous];
  const int distance = needle_distance(first.hangs_on, second.hangs_on, racking);
  fabric_.max_stretch = std::max(fabric_.max_stretch, distance);
  const int allowed = std::max(kQuarters * profile_.max_stretch, second.made_distance);
  if (distance <= allowed) return;
  log_.error("overstretched", line,
             "the yarn between " + to_string(first.hangs_on) + " and " +
                 to_string(second.hangs_on) + " is pulled to " + in_needles(distance) +
                 " needles; it has slack for " + in_needles(allowed),
             {named_stitch(first), named_stitch(second)});
}

void YarnSlack::watch_bridge(int pair) {
  if (!held(pair)) return;
  const Loop& second = fabric_.loops[pair];
  if (second.hangs_on.bed == fabric_.loops[second.previous].hangs_on.bed) return;
  bridge_at_[pair] = static_cast<int>(bridges_.size());
  bridges_.push_back(pair);
}

void YarnSlack::unwatch_bridge(int pair) {
  const int at = bridge_at_[pair];
  if (at < 0) return;
  bridges_[at] = bridges_.back();
  bridge_at_[bridges_[at]] = at;
  bridges_.pop_back();
  bridge_at_[pair] = -1;
}

}  // namespace meshknit
