// The random tubes of graphs.h.

#include <algorithm>

#include "graphs.h"

namespace meshknit {
namespace {

/// Draws rows that keep to Properties 3 and 4 whatever the dice say.
class RandomTube {
 public:
  explicit RandomTube(std::uint64_t seed) : dice_(seed) {}

  KnitGraph draw() {
    front_ = drawing_.cast_on(5 + dice_.roll(20));
    note_new_row(true);
    const int rows = 7 + dice_.roll(32);
    while (drawing_.rows() < rows) {
      const bool closed = dice_.roll(2) == 0 || front_.size() < 6;
      closed ? draw_closed_row() : draw_short_row();
    }
    draw_closed_row();
    return drawing_.graph();
  }

 private:
  int size() const { return static_cast<int>(front_.size()); }

  /// Links over `count` front nodes from `begin` on.
  std::string random_links(int begin, int count, bool closed) {
    std::string row;
    int above = 0;
    for (int i = 0; i < count; ++i) {
      const int node = front_[(begin + i) % size()];
      const bool row_end = !closed && (i == 0 || i == count - 1);
      const int kind = ends_[node] || row_end ? 0 : dice_.roll(8);
      const int nodes_left = count - i;
      if (kind == 1 && above + nodes_left < 40) {
        row += 'Y';
        above += 2;
      } else if (kind == 2 && above + nodes_left > 6 && i + (closed ? 1 : 2) < count &&
                 are_neighbours(node, front_[(begin + i + 1) % size()])) {
        row += 'A';
        ++above;
        ++i;
      } else {
        row += '|';
        ++above;
      }
    }
    return row;
  }

  bool are_neighbours(int a, int b) const { return !ends_[b] && row_of_[a] == row_of_[b]; }

  void draw_closed_row() {
    const std::string row = random_links(0, size(), true);
    front_ = drawing_.closed_row(front_, row, dice_.roll(static_cast<int>(row.size())));
    note_new_row(true);
  }

  void draw_short_row() {
    // One row in four over what the last one covered, so that ends come to lie above ends.
    int begin = dice_.roll(size()), count = 2 + dice_.roll(size() - 3);
    const KnitRow& last = drawing_.row(drawing_.rows() - 1);
    if (!last.closed && dice_.roll(4) == 0) {
      const auto found = std::find(front_.begin(), front_.end(), last.nodes.front());
      begin = static_cast<int>(found - front_.begin());
      count = static_cast<int>(last.nodes.size());
    }
    front_ = drawing_.short_row(front_, begin, random_links(begin, count, false));
    note_new_row(false);
  }

  void note_new_row(bool closed) {
    const int index = drawing_.rows() - 1;
    const std::vector<int>& nodes = drawing_.row(index).nodes;
    const std::size_t total = *std::max_element(nodes.begin(), nodes.end()) + 1;
    ends_.resize(total, false);
    row_of_.resize(total, index);
    if (!closed) ends_[nodes.front()] = ends_[nodes.back()] = true;
  }

  Dice dice_;
  GraphDrawing drawing_;
  GraphDrawing::Front front_;
  std::vector<bool> ends_;  ///< node is an end of a short row
  std::vector<int> row_of_;
};

}  // namespace

KnitGraph random_tube(std::uint64_t seed) { return RandomTube(seed).draw(); }

}  // namespace meshknit
