#include "meshknit/remesh/tube_peeling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "meshknit/surface/wording.h"

namespace meshknit {
namespace {

// Shortest short row: three nodes are 2 l_r long.
constexpr int fewest_in_short_row = 3;

// Shorter runs than this wait until they are two rows late: a sixth of a narrow row, a dozen
// stitches of a middling one, a tenth of a wide one.
int worthwhile_run(int count) { return std::min(count / 6, std::max(12, count / 10)); }

// How far beyond its last node a short row's end reaches, as a fraction of the way to the next
// node.
constexpr double beyond_end = 0.1;

// A column that leans more than this is a flaw of its row and says nothing of the next.
constexpr double most_lean = 1.3;

// How fast the expected lean follows that of the last rows.
constexpr double lean_update = 0.3;

// Where the way to the end is shared out, no row is higher than this, in rows.
constexpr double highest = 1.25;

// A part of a row that stands higher than this part of a row's height is worth knitting.
constexpr double least_height = 0.7;

std::vector<double> times_of(const PeelState& state, const Cycle& cycle) {
  std::vector<double> times;
  for (const EdgeCrossing& c : cycle.crossings) {
    const double u = state.time[state.from(c.halfedge)], w = state.time[state.to(c.halfedge)];
    times.push_back(u + c.t * (w - u));
  }
  return times;
}

int partner_of(const std::vector<Link>& links, int next) {
  for (const Link& link : links)
    if (link[1] == next) return link[0];
  throw BrokenPromise("a node of the next row has no column");
}

}  // namespace

TubePeeling::TubePeeling(Peel& peel, int arc, ActiveCycle active, int fewest)
    : peel_(peel), arc_(arc), active_(std::move(active)), fewest_(fewest) {
  const int end = peel.plan.reeb.arcs[arc].to;
  if (peel.plan.reeb.events[end].below.size() > 2) last_unit_ = 2;
}

void TubePeeling::resume() {
  peel_.limits.close_all();
  peel_.limits.open(arc_);
}

bool TubePeeling::peel_row() {
  if (ended_) return false;
  const RestOfTube rest =
      rest_of_tube(peel_.state, peel_.plan, arc_, active_.cycle, row_height());
  if (whole_ && rest.mean < 0.5 * peel_.row_height && rest.most < peel_.row_height)
    return false;
  if (rest.near) unit_ = last_unit_;
  const bool last = rest.near && rest.rows == 1;
  if (rest.near && even_out(rest)) return true;
  if (last) {
    knit_last(rest);
    return true;
  }
  const RowLevel level =
      rest.near ? RowLevel::part_of_rest(rest.rows, highest * row_height(), peel_.plan)
                : RowLevel::of_height(rest.height);
  peel_.band.measure({&active_.cycle}, 1.2 * highest * peel_.row_height);
  Candidate c = candidate(level);
  if (!rest.near) {
    c.row.runs = accept(c, worthwhile_run(static_cast<int>(c.row.place.size())));
    if (!c.row.runs.empty() && knit_runs(c, c.row.runs)) return true;
  }
  c.row.runs.clear();
  if (knit(c) || knit_into_pocket(level) || knit(c, Turns::apart, large_pocket)) return true;
  if (rest.near && rest.rows <= 2) {
    knit_last(rest);
    return true;
  }

  const int vertex = peel_.state.to(c.next.cycle.crossings.front().halfedge);
  Problem problem;
  problem.code = "splits-here";
  problem.message =
      "Near " + place_text(peel_.state.point(vertex)) +
      " the rows would close round a part that stands out and is too thin for its "
      "length: at this gauge no row can reach its tip.";
  problem.remedy =
      "Make an opening at the tip of this part, place times so that rows pass over it, make it "
      "wider or shorter, or take finer stitches.";
  problem.elements.faces = peel_.faces_near(vertex);
  throw NotKnittable({problem});
}

TubePeeling::Candidate TubePeeling::candidate(const RowLevel& level) {
  std::vector<NextCycle> cycles = peel_.slicer.slice(peel_.band, {&active_.cycle}, level);
  if (cycles.empty()) throw BrokenPromise("slicing found no next cycle");
  Candidate c{level, {}, {}, {}};
  c.next = std::move(cycles.front());
  c.images = images_on_next(active_, 0, c.next);
  c.row.place =
      sample_next_row(active_, c.next, c.images, peel_.options.stitch_width, fewest_, unit_);
  for (const double place : c.row.place)
    c.row.time.push_back(c.next.cycle.value(c.next.cycle.at(place), c.next.time));
  return c;
}

void TubePeeling::knit_last(const RestOfTube& rest) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  peel_.band.measure({&active_.cycle}, rest.most + 2.0 * peel_.row_height);
  Candidate c = candidate(RowLevel::part_of_rest(1, infinity, peel_.plan));
  link(c);
  if (c.row.links.empty()) throw BrokenPromise("linking found no columns between two rows");
  for (const EdgeCrossing& crossing : c.next.cycle.crossings)
    peel_.state.crossing[crossing.halfedge >> 1] = crossing.t;
  for (const int v : peel_.plan.vertices_of_region[arc_]) {
    peel_.knitted += !peel_.state.knitted[v];
    peel_.state.knitted[v] = 1;
  }
  add(c, c.next.cycle);
  ended_ = true;
}

bool TubePeeling::knit(Candidate c, Turns turns, std::size_t largest_pocket) {
  const bool short_rows = !c.row.runs.empty();
  if (turns == Turns::apart)
    keep_turns_apart(c);
  else
    link(c);
  if (c.row.links.empty()) return false;
  if (short_rows && c.row.runs.empty()) return false;
  std::optional<Cycle> cycle = peel_.trimmer.trim(peel_.band, active_.cycle, c.next.cycle,
                                                  c.level, regions(c), largest_pocket);
  if (!cycle || peel_.trimmer.newly_knitted() == 0) return false;
  peel_.knitted += peel_.trimmer.newly_knitted();
  peel_.left_out.insert(peel_.left_out.end(), peel_.trimmer.pockets().begin(),
                        peel_.trimmer.pockets().end());
  add(c, std::move(*cycle));
  return true;
}

bool TubePeeling::knit_runs(const Candidate& c, std::vector<NodeRun> runs, Turns turns) {
  Candidate some = c;
  some.row.runs = std::move(runs);
  return knit(std::move(some), turns);
}

bool TubePeeling::knit_into_pocket(const RowLevel& level) {
  // What closes the part off lies later than the part itself: leave the latest out, as little as
  // will do.
  std::vector<double> times;
  for (const int v : peel_.band.reached())
    if (peel_.limits.may_knit(v)) times.push_back(peel_.state.time[v]);
  std::sort(times.begin(), times.end());
  if (times.empty()) return false;
  for (const Turns turns : {Turns::apart, Turns::anywhere})
    for (int percent = 97; percent > 0; percent -= 5) {
      const double latest = times[percent * (times.size() - 1) / 100];
      const Candidate c = candidate(level.not_later_than(latest, peel_.state));
      std::vector<double> lack;  // of height
      for (const double place : c.row.place)
        lack.push_back(least_height * row_height() -
                       c.next.cycle.value(c.next.cycle.at(place), c.next.gap));
      const std::vector<double> gains(lack.size(), 0.0);
      std::vector<NodeRun> runs =
          accept_by_time(lack, gains, 0.0, fewest_in_short_row, fewest_in_short_row);
      if (!runs.empty() && knit_runs(c, std::move(runs), turns)) return true;
    }
  return false;
}

double TubePeeling::foot_of(const NextCycle& next, double place) const {
  const CyclePoint p = next.cycle.at(place);
  const double a = next.foot[p.piece], b = next.foot[(p.piece + 1) % next.cycle.size()];
  return a + p.along * around(a, b, active_.cycle.length());
}

std::vector<NodeRun> TubePeeling::accept(const Candidate& c, int worthwhile) const {
  const Cycle& active = active_.cycle;
  const std::vector<double> active_times = times_of(peel_.state, active);
  std::vector<double> gains;
  for (std::size_t j = 0; j < c.row.place.size(); ++j) {
    const CyclePoint below = active.at(foot_of(c.next, c.row.place[j]));
    gains.push_back(c.row.time[j] - active.value(below, active_times));
  }
  return accept_by_time(c.row.time, gains,
                        *std::max_element(active_times.begin(), active_times.end()),
                        fewest_in_short_row, worthwhile);
}

bool TubePeeling::even_out(const RestOfTube& rest) {
  const double height = row_height(), enough = (rest.rows + 0.5) * height;
  if (rest.most < enough) return false;
  peel_.band.measure({&active_.cycle}, 1.2 * height);
  const Candidate c = candidate(RowLevel::of_height(height));
  std::vector<double> lateness;
  for (const double place : c.row.place) {
    const CyclePoint below = active_.cycle.at(foot_of(c.next, place));
    lateness.push_back(enough - active_.cycle.value(below, rest.at_crossing));
  }
  const std::vector<double> gains(lateness.size(), height);
  std::vector<NodeRun> runs =
      accept_by_time(lateness, gains, 0.0, fewest_in_short_row, fewest_in_short_row);
  if (!runs.empty()) return knit_runs(c, std::move(runs));
  // Where all but a few stitches are wanted, the row is whole.
  const auto wanted =
      std::count_if(lateness.begin(), lateness.end(), [](double late) { return late <= 0.0; });
  return 2 * wanted > static_cast<std::ptrdiff_t>(lateness.size()) && knit(c);
}

void TubePeeling::link(Candidate& c) const {
  NextRow& row = c.row;
  const int count = static_cast<int>(row.place.size());
  row.single.assign(count, 0);
  for (const NodeRun& run : row.runs) row.single[run.first] = row.single[run.last] = 1;
  LinkProblem problem;
  for (const ActiveNode& node : active_.nodes) {
    problem.active.push_back(node.place);
    problem.active_single.push_back(node.single);
    problem.active_shaped.push_back(node.shaped);
  }
  for (const NodeImage& image : c.images) problem.image.push_back(image.place);
  problem.active_length = active_.cycle.length();
  problem.next = row.place;
  for (const double place : row.place) {
    problem.foot.push_back(foot_of(c.next, place));
    problem.gap.push_back(c.next.cycle.value(c.next.cycle.at(place), c.next.gap));
  }
  problem.next_single = row.single;
  problem.next_length = c.next.cycle.length();
  problem.row_height = peel_.row_height;
  row.links = link_rows(problem);
  double sum = 0.0;
  for (const Link& l : row.links)
    sum +=
        std::min(most_lean, std::hypot(1.0, sideways(problem, l[0], l[1]) / peel_.row_height));
  if (!row.links.empty()) c.lean = sum / static_cast<double>(row.links.size());
}

// Links the row. A short row must not end right above the end of another: the tucks of both
// turns would pile up on one needle. Runs are shortened until none does.
void TubePeeling::keep_turns_apart(Candidate& c) const {
  NextRow& row = c.row;
  const int count = static_cast<int>(row.place.size());
  for (;;) {
    link(c);
    if (row.links.empty()) {
      if (row.runs.empty()) throw BrokenPromise("linking found no columns between two rows");
      row.runs.clear();
      continue;
    }
    bool changed = false;
    std::vector<NodeRun> runs;
    for (NodeRun run : row.runs) {
      const int size = run.size(count);
      const bool first_on_end = active_.nodes[partner_of(row.links, run.first)].row_end;
      const bool last_on_end = active_.nodes[partner_of(row.links, run.last)].row_end;
      changed = changed || first_on_end || last_on_end;
      if (size - first_on_end - last_on_end < fewest_in_short_row) continue;
      if (first_on_end) run.first = (run.first + 1) % count;
      if (last_on_end) run.last = (run.last + count - 1) % count;
      runs.push_back(run);
    }
    if (!changed) return;
    row.runs = runs;
  }
}

std::vector<TrimRegion> TubePeeling::regions(const Candidate& c) const {
  const NextRow& row = c.row;
  const int count = static_cast<int>(row.place.size());
  const int active_count = static_cast<int>(active_.nodes.size());
  const double length = active_.cycle.length(), spacing = c.next.cycle.length() / count;
  const auto foot_at = [&](double place) {
    return forward(0.0, foot_of(c.next, place), length);
  };
  std::vector<TrimRegion> regions;
  for (const NodeRun& run : row.runs) {
    const int a = partner_of(row.links, run.first), b = partner_of(row.links, run.last);
    const double before = active_.nodes[(a + active_count - 1) % active_count].place;
    const double after = active_.nodes[(b + 1) % active_count].place;
    TrimRegion region;
    region.begin_below = before + beyond_end * forward(before, active_.nodes[a].place, length);
    region.begin_above = foot_at(row.place[run.first] - beyond_end * spacing);
    region.end_below = after - beyond_end * forward(active_.nodes[b].place, after, length);
    region.end_above = foot_at(row.place[run.last] + beyond_end * spacing);
    regions.push_back(region);
  }
  return regions;
}

// Adds the row to the graph and makes it, or what it covers, the active cycle.
void TubePeeling::add(const Candidate& c, Cycle cycle) {
  const NextRow& row = c.row;
  const int count = static_cast<int>(row.place.size());
  const int below_count = static_cast<int>(active_.nodes.size());
  const std::vector<int> node_of = peel_.builder.add_rows(c.next, row);
  std::vector<int> up(below_count, 0), down(count, 0);
  for (const Link& l : row.links) {
    if (node_of[l[1]] >= 0) peel_.builder.add_column(active_.nodes[l[0]].node, node_of[l[1]]);
    ++up[l[0]];
    ++down[l[1]];
  }
  std::vector<char> child_of_increase(row.place.size(), 0);
  for (const Link& l : row.links) child_of_increase[l[1]] |= up[l[0]] > 1;
  const auto above = [&](int j) {
    ActiveNode node = active_node(c.next, row.place[j], node_of[j]);
    node.shaped = down[j] > 1 || child_of_increase[j];
    node.single = node.row_end = row.single[j];
    return node;
  };

  std::vector<ActiveNode> nodes;
  whole_ = row.runs.empty();
  lean_ += lean_update * (c.lean - lean_);
  if (whole_) {
    for (int j = 0; j < count; ++j) nodes.push_back(above(j));
  } else {
    std::vector<int> run_at(below_count, -1);  // run that begins over this active node
    std::vector<char> covered(active_.nodes.size(), 0);
    for (std::size_t r = 0; r < row.runs.size(); ++r) {
      const int a = partner_of(row.links, row.runs[r].first);
      const int b = partner_of(row.links, row.runs[r].last);
      run_at[a] = static_cast<int>(r);
      for (int i = a;; i = (i + 1) % below_count) {
        covered[i] = 1;
        if (i == b) break;
      }
      active_.nodes[(a + below_count - 1) % below_count].single = true;
      active_.nodes[(b + 1) % below_count].single = true;
    }
    for (int i = 0; i < below_count; ++i) {
      if (!covered[i]) nodes.push_back(active_.nodes[i]);
      if (run_at[i] < 0) continue;
      const NodeRun& run = row.runs[run_at[i]];
      for (int k = 0; k < run.size(count); ++k) nodes.push_back(above((run.first + k) % count));
    }
  }
  active_.nodes = std::move(nodes);
  active_.cycle = std::move(cycle);
  place_nodes(active_, peel_.piece_of_edge);
}

}  // namespace meshknit
