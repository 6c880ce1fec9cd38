#include "meshknit/schedule/bed_layout.h"

#include <algorithm>
#include <cstdlib>

namespace meshknit {
namespace {

// Needles from place 0 of the front bed to this place of the back bed.
int needles_across(int places) { return std::abs(2 * places + 1); }

}  // namespace

std::vector<BedShape> bed_shapes(int slots) {
  std::vector<BedShape> shapes;
  const auto add = [&](int front, int left) {
    if (front >= 1 && front < slots) shapes.push_back({front, left});
  };
  const int half = slots / 2;
  if (slots % 2 == 0) {
    add(half, 0);
    add(half, 1);
    add(half, -1);
    add(half + 1, 1);
    add(half - 1, -1);
  } else {
    add(half + 1, 0);
    add(half + 1, 1);
    add(half, 0);
    add(half, -1);
  }
  return shapes;
}

bool is_aligned(const BedLayout& layout) {
  return layout.shape.left == 0 && 2 * layout.shape.front == layout.slots;
}

int longest_bridge(const BedLayout& layout) {
  const int right = layout.shape.left + layout.slots - 2 * layout.shape.front;
  return std::max(needles_across(layout.shape.left), needles_across(right));
}

int longest_bridge(const std::vector<Hook>& hooks) {
  std::vector<int> front, back;
  for (const Hook& hook : hooks) (hook.bed == Bed::front ? front : back).push_back(hook.n);
  if (front.empty() || back.empty()) return 1;
  const auto [front_left, front_right] = std::minmax_element(front.begin(), front.end());
  const auto [back_left, back_right] = std::minmax_element(back.begin(), back.end());
  return std::max(needles_across(*back_left - *front_left),
                  needles_across(*back_right - *front_right));
}

Hook slot_hook(const BedLayout& layout, int slot) {
  const int turn = (slot - layout.first + layout.slots) % layout.slots;
  const int front = layout.shape.front;
  if (turn < front) return {Bed::front, layout.place + turn};
  // The back bed is walked from its right end, which is slots - front - 1 places from its left
  // end.
  return {Bed::back, layout.place + layout.shape.left + (layout.slots - 1 - turn)};
}

PlaceRange places_of(const BedLayout& layout) {
  const int back = layout.slots - layout.shape.front;
  const int back_left = layout.place + layout.shape.left;
  return {std::min(layout.place, back_left),
          std::max(layout.place + layout.shape.front, back_left + back) - 1};
}

int places_between(const BedLayout& left, const BedLayout& right) {
  const int front = right.place - (left.place + left.shape.front);
  const int back_end = left.place + left.shape.left + left.slots - left.shape.front;
  return std::min(front, right.place + right.shape.left - back_end);
}

}  // namespace meshknit
