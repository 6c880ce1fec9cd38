#include "meshknit/verify/trace_columns.h"

#include <algorithm>

namespace meshknit {
namespace {

class ColumnFinder {
 public:
  explicit ColumnFinder(const StitchTrace& trace)
      : trace_(trace), yarn_at_(static_cast<std::size_t>(trace.yarns), -1) {
    found_.of.assign(trace.stitches.size(), {-1, -1});
    found_.cast_on.assign(trace.stitches.size(), -1);
    last_of_yarn_.assign(static_cast<std::size_t>(trace.yarns), -1);
  }

  TraceColumns run() {
    for (int s = 0; s < static_cast<int>(trace_.stitches.size()); ++s) {
      const Stitch& stitch = trace_.stitches[s];
      if (stitch.kind == StitchKind::start) {
        start(s);
      } else if (stitch.kind == StitchKind::tuck) {
        const int host = host_of(s);
        step(s, host);
        found_.of[s][0] = host;
      } else {
        knit(s);
      }
      last_of_yarn_[stitch.yarn] = s;
    }
    found_.columns = static_cast<int>(next_.size());
    return std::move(found_);
  }

 private:
  bool anticlockwise(int s) const {
    return trace_.stitches[s].direction == Direction::anticlockwise;
  }
  int ahead(int column, int s) const {
    return anticlockwise(s) ? next_[column] : previous_[column];
  }

  // A column that a decrease ended is the one that it went into.
  int live(int column) const {
    while (column >= 0 && joined_[column] >= 0) column = joined_[column];
    return column;
  }

  int column_of(const ExpectedLoop& loop) const {
    return live(found_.of[loop.stitch][loop.which]);
  }

  int new_column(int s) {
    const int column = static_cast<int>(next_.size());
    next_.push_back(column);
    previous_.push_back(column);
    used_.push_back(s);
    joined_.push_back(-1);
    child_.push_back(-1);
    return column;
  }

  // Between `column` and the one ahead of it.
  int new_column_ahead(int column, int s) {
    const int added = new_column(s);
    const int before = anticlockwise(s) ? column : previous_[column];
    const int after = next_[before];
    next_[before] = previous_[after] = added;
    next_[added] = after;
    previous_[added] = before;
    used_[before] = s;
    return added;
  }

  void hang(const ExpectedLoop& loop, int column) {
    const std::vector<int>& children = trace_.stitches[loop.stitch].children;
    found_.of[loop.stitch][loop.which] = column;
    child_[column] = children.empty() ? -1 : children[loop.which];
  }

  void start(int s) {
    int& at = yarn_at_[trace_.stitches[s].yarn];
    const int last = last_of_yarn_[trace_.stitches[s].yarn];
    const bool goes_on = last >= 0 && trace_.stitches[last].kind == StitchKind::start;
    if (!goes_on) ++cast_ons_;
    found_.cast_on[s] = cast_ons_ - 1;
    at = goes_on ? new_column_ahead(at, s) : new_column(s);
    hang({s, 0}, at);
  }

  // The column of the loop that a tuck lies on: the stitch above names it right before the tuck.
  int host_of(int tuck) const {
    const int above = trace_.stitches[tuck].children.front();
    int host = -1;
    const std::vector<ExpectedLoop> parents = expected_parents(trace_, above);
    for (const ExpectedLoop& parent : parents) {
      if (parent.stitch == tuck) break;
      if (trace_.stitches[parent.stitch].kind != StitchKind::tuck) host = column_of(parent);
    }
    return host;
  }

  void knit(int s) {
    int first = -1;
    for (const ExpectedLoop& parent : expected_parents(trace_, s)) {
      if (trace_.stitches[parent.stitch].kind == StitchKind::tuck) continue;
      const int column = column_of(parent);
      if (column < 0) continue;
      if (first < 0) {
        first = column;
        step(s, first);
      } else if (column != first) {
        end_column(column, first, s);
      }
    }
    if (first < 0) return;
    hang({s, 0}, first);
    if (trace_.stitches[s].kind != StitchKind::increase) return;
    int& at = yarn_at_[trace_.stitches[s].yarn];
    at = new_column_ahead(first, s);
    hang({s, 1}, at);
  }

  void end_column(int column, int into, int s) {
    const int before = previous_[column];
    const int after = next_[column];
    next_[before] = after;
    previous_[after] = before;
    used_[before] = s;
    joined_[column] = into;
  }

  // The yarn goes to a column, the neighbour ahead unless tubes part or meet here.
  void step(int s, int to) {
    int& at = yarn_at_[trace_.stitches[s].yarn];
    const int from = live(at);
    if (to >= 0 && from >= 0 && from != to) {
      int beside = from;
      if (ahead(from, s) != to && ahead(ahead(from, s), s) == to &&
          decreased(from, ahead(from, s))) {
        beside = ahead(from, s);
        use(from, beside, s);
      }
      if (ahead(beside, s) != to) join(s, beside, to);
      use(beside, to, s);
    }
    at = to;
  }

  void use(int from, int to, int s) { used_[anticlockwise(s) ? from : to] = s; }

  // One stitch is still to be knit through both. The yarn that climbs beside it passes both.
  bool decreased(int column, int other) const {
    return child_[column] >= 0 && child_[column] == child_[other];
  }

  void join(int s, int from, int to) {
    Junction junction;
    junction.first = anticlockwise(s) ? from : to;
    junction.second = anticlockwise(s) ? to : from;
    junction.stitch = s;
    const int after = next_[junction.first];
    const int before = previous_[junction.second];
    junction.opens = std::max(used_[junction.first], used_[before]);
    found_.junctions.push_back(junction);
    next_[junction.first] = junction.second;
    previous_[junction.second] = junction.first;
    next_[before] = after;
    previous_[after] = before;
    used_[junction.first] = used_[before] = s;
  }

  const StitchTrace& trace_;
  TraceColumns found_;
  std::vector<int> next_, previous_;  // column -> its neighbours anticlockwise and clockwise
  std::vector<int> used_;    // column -> last stitch to use or make its `next_` neighbourhood
  std::vector<int> child_;   // column -> stitch that is to be knit through its loop
  std::vector<int> joined_;  // column -> the one that a decrease took it into
  std::vector<int> yarn_at_, last_of_yarn_;  // yarn -> column, stitch
  int cast_ons_ = 0;
};

}  // namespace

TraceColumns find_trace_columns(const StitchTrace& trace) { return ColumnFinder(trace).run(); }

}  // namespace meshknit
