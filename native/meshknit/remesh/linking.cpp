#include "meshknit/remesh/linking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshknit/remesh/front.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Charges in units of one well-placed link. They spread shaping: two shaping moves side by
// side, or one above another, make a weak spot. Small against the cost of leaning a link by
// half a stitch.
constexpr double beside_shaping = 0.15;
constexpr double above_shaping = 0.05;

enum Move : unsigned char { one_to_one, one_to_two, two_to_one, none };

// Dynamic programme over (active nodes used, next nodes used, last move) from a first pair on,
// within a band round the expected pairing.
class RowLinker {
 public:
  RowLinker(const LinkProblem& problem, int first_active, int first_next)
      : p_(problem),
        m_(static_cast<int>(problem.active.size())),
        n_(static_cast<int>(problem.next.size())),
        first_active_(first_active),
        first_next_(first_next) {}

  double solve(int half_width) {
    lay_band(half_width);
    cells_.assign(offset_.back(), Cell{});
    at(0, 0)->cost[one_to_one] = 0.0;
    weigh_row(0);
    for (int i = 0; i <= m_; ++i) {
      std::swap(here_, above_);
      if (i + 1 < m_) weigh_row(i + 1);
      for (int j = low_[i]; j <= high_[i]; ++j) advance(i, j);
    }
    const Cell* end = at(m_, n_);
    if (!end) return infinity;
    last_ = static_cast<Move>(std::min_element(end->cost, end->cost + 3) - end->cost);
    return end->cost[last_];
  }

  std::vector<Link> links() const {
    std::vector<Link> links;
    int i = m_, j = n_;
    Move move = last_;
    while (i > 0 || j > 0) {
      const Move before = at(i, j)->before[move];
      const int di = move == two_to_one ? 2 : 1, dj = move == one_to_two ? 2 : 1;
      for (int a = di; a-- > 0;)
        for (int b = dj; b-- > 0;)
          links.push_back({active_at(i - di + a), next_at(j - dj + b)});
      i -= di;
      j -= dj;
      move = before;
    }
    std::reverse(links.begin(), links.end());
    return links;
  }

 private:
  struct Cell {
    double cost[3] = {infinity, infinity, infinity};
    Move before[3] = {none, none, none};
  };

  int active_at(int i) const { return wrapped(first_active_ + i, m_); }
  int next_at(int j) const { return wrapped(first_next_ + j, n_); }
  static int wrapped(int i, int n) {
    while (i >= n) i -= n;
    return i;
  }

  void lay_band(int half_width) {
    low_.resize(m_ + 1);
    high_.resize(m_ + 1);
    offset_.assign(1, 0);
    double expected = 0.0;
    for (int i = 0; i <= m_; ++i) {
      if (i > 0) {
        const double spacing = p_.next_length / n_;
        const double there =
            i == m_ ? n_
                    : forward(p_.next[next_at(0)], p_.image[active_at(i)], p_.next_length) /
                          spacing;
        // An image may lie a little before the start, or jump where the cycle bends: keep near
        // the even pairing.
        const double even = static_cast<double>(i) * n_ / m_;
        if (std::abs(there - even) < 0.25 * n_)
          expected = std::max(expected, there);
        else
          expected = std::max(expected, even);
      }
      const int centre = static_cast<int>(std::lround(expected));
      low_[i] = std::clamp(centre - half_width, 0, n_);
      high_[i] = std::clamp(centre + half_width, 0, n_);
      offset_.push_back(offset_.back() + high_[i] - low_[i] + 1);
    }
  }
  Cell* at(int i, int j) {
    return j < low_[i] || j > high_[i] ? nullptr : &cells_[offset_[i] + j - low_[i]];
  }
  const Cell* at(int i, int j) const { return const_cast<RowLinker*>(this)->at(i, j); }

  // What links of an active node cost, to the next nodes from `first` on.
  struct RowCosts {
    int first = 0;
    std::vector<double> cost;
    double operator[](int j) const { return cost[j - first]; }
  };

  // All links of a node that the band and the rows before and after it ask for.
  void weigh_row(int i) {
    above_.first = low_[std::max(0, i - 1)];
    above_.cost.clear();
    for (int j = above_.first; j <= high_[i] + 1; ++j) {
      const double gap = p_.gap[next_at(j)], side = sideways(p_, active_at(i), next_at(j));
      above_.cost.push_back((gap * gap + side * side) / (p_.row_height * p_.row_height));
    }
  }

  void advance(int i, int j) {
    const Cell* here = at(i, j);
    if (*std::min_element(here->cost, here->cost + 3) == infinity) return;
    const auto active_single = [&](int k) { return p_.active_single[active_at(k)]; };
    const auto next_single = [&](int k) { return p_.next_single[next_at(k)]; };
    if (i < m_ && j < n_) reach(i, j, i + 1, j + 1, one_to_one, here_[j]);
    if (i < m_ && j + 1 < n_ && !active_single(i) && !next_single(j) && !next_single(j + 1))
      reach(i, j, i + 1, j + 2, one_to_two, here_[j] + here_[j + 1] + stacked(i));
    if (i + 1 < m_ && j < n_ && !active_single(i) && !active_single(i + 1) && !next_single(j))
      reach(i, j, i + 2, j + 1, two_to_one, here_[j] + above_[j] + stacked(i) + stacked(i + 1));
  }
  double stacked(int i) const { return p_.active_shaped[active_at(i)] ? above_shaping : 0.0; }

  void reach(int i, int j, int to_i, int to_j, Move move, double cost) {
    Cell* to = at(to_i, to_j);
    if (!to) return;
    const Cell* here = at(i, j);
    for (int last = 0; last < 3; ++last) {
      const bool both = last != one_to_one && move != one_to_one;
      const double sum = here->cost[last] + cost + (both ? beside_shaping : 0.0);
      if (sum < to->cost[move]) {
        to->cost[move] = sum;
        to->before[move] = static_cast<Move>(last);
      }
    }
  }

  const LinkProblem& p_;
  int m_, n_, first_active_, first_next_;
  std::vector<int> low_, high_, offset_;
  std::vector<Cell> cells_;
  RowCosts here_, above_;  // of the active node that is being linked, and of the next one
  Move last_ = none;
};

}  // namespace

double sideways(const LinkProblem& p, int active, int next) {
  return 0.5 * (around(p.active[active], p.foot[next], p.active_length) +
                around(p.image[active], p.next[next], p.next_length));
}

std::array<int, 2> linkable_counts(const std::vector<char>& single) {
  const int m = static_cast<int>(single.size());
  const int first =
      static_cast<int>(std::find(single.begin(), single.end(), 1) - single.begin());
  if (first == m) return {(m + 1) / 2, 2 * m};
  int least = 0, most = 0, run = 0;
  for (int k = 1; k <= m; ++k) {
    if (!single[(first + k) % m]) {
      ++run;
      continue;
    }
    least += 1 + (run + 1) / 2;
    most += 1 + 2 * run;
    run = 0;
  }
  return {least, most};
}

std::vector<Link> link_rows(const LinkProblem& problem) {
  const int m = static_cast<int>(problem.active.size());
  const int n = static_cast<int>(problem.next.size());
  if (m == 0 || n == 0) return {};
  // The pair that faces each other best is linked in any good solution: begin there.
  int active = 0, next = 0;
  double best = infinity;
  for (int i = 0; i < m; ++i) {
    const double place = problem.image[i] / problem.next_length * n;
    for (int step = 0; step < 2; ++step) {
      // Next nodes are evenly spread but may start anywhere.
      const double shift = problem.next[0] / problem.next_length * n;
      const int j = (static_cast<int>(std::floor(place - shift)) + step + 2 * n) % n;
      const double off =
          std::abs(sideways(problem, i, j)) + (problem.active_single[i] ? -1e-6 : 0.0);
      if (off < best) {
        best = off;
        active = i;
        next = j;
      }
    }
  }
  const std::array<std::array<int, 2>, 3> starts = {
      {{active, next}, {active, (next + n - 1) % n}, {(active + m - 1) % m, next}}};
  for (const int half_width : {8 + n / 50, n}) {
    double least = infinity;
    std::vector<Link> links;
    for (const auto& start : starts) {
      RowLinker linker(problem, start[0], start[1]);
      const double cost = linker.solve(half_width);
      if (cost < least) {
        least = cost;
        links = linker.links();
      }
    }
    if (least < infinity) return links;
  }
  return {};
}

}  // namespace meshknit
