#include "meshknit/verify/tube_order.h"

#include <iterator>

namespace meshknit {

int TubeOrder::insert(const Needle& needle) {
  return insert_after(last_before(needle), needle);
}

int TubeOrder::insert_after(int before, const Needle& needle) {
  const int column = static_cast<int>(columns_.size());
  columns_.emplace_back();
  if (before < 0) {
    columns_[column].next = columns_[column].previous = column;
  } else {
    const int after = columns_[before].next;
    columns_[column].previous = before;
    columns_[column].next = after;
    columns_[before].next = columns_[after].previous = column;
  }
  hang(column, needle);
  refresh_place(columns_[column].previous);
  return column;
}

void TubeOrder::move(int column, const Needle& to) {
  unhang(column);
  hang(column, to);
}

void TubeOrder::remove(int column) {
  unhang(column);
  const int before = columns_[column].previous;
  const int after = columns_[column].next;
  columns_[before].next = after;
  columns_[after].previous = before;
  if (before != column) refresh_place(before);
}

Needle TubeOrder::needle(int column) const {
  const Column& c = columns_[column];
  const bool slider = c.key % 2 != 0;
  return {c.bed, (c.key - (slider ? 1 : 0)) / 2, slider};
}

// The reading order: front bed left to right, then back bed right to left, and round again.
int TubeOrder::read_next(Bed bed, int key) const {
  const auto& front = reading_[0];
  const auto& back = reading_[1];
  if (bed == Bed::front) {
    const auto right = front.upper_bound(key);
    if (right != front.end()) return right->second;
    if (!back.empty()) return back.rbegin()->second;
    return front.empty() ? -1 : front.begin()->second;
  }
  const auto here = back.lower_bound(key);
  if (here != back.begin()) return std::prev(here)->second;
  if (!front.empty()) return front.begin()->second;
  return back.empty() ? -1 : back.rbegin()->second;
}

int TubeOrder::read_previous(Bed bed, int key) const {
  const auto& front = reading_[0];
  const auto& back = reading_[1];
  if (bed == Bed::front) {
    const auto here = front.lower_bound(key);
    if (here != front.begin()) return std::prev(here)->second;
    if (!back.empty()) return back.begin()->second;
    return front.empty() ? -1 : front.rbegin()->second;
  }
  const auto right = back.upper_bound(key);
  if (right != back.end()) return right->second;
  if (!front.empty()) return front.rbegin()->second;
  return back.empty() ? -1 : back.begin()->second;
}

void TubeOrder::hang(int column, const Needle& needle) {
  Column& c = columns_[column];
  c.bed = needle.bed;
  c.key = key_of(needle);
  auto& reading = reading_[side(c.bed)];
  c.bed_next = c.bed_previous = column;
  if (!reading.empty()) {
    // The nearest column of this bed along the list, sought both ways at once.
    int after = c.next;
    int before = c.previous;
    const auto elsewhere = [&](int other) {
      return other == column || columns_[other].bed != c.bed || columns_[other].bed_next < 0;
    };
    while (elsewhere(after) && elsewhere(before)) {
      after = columns_[after].next;
      before = columns_[before].previous;
    }
    if (!elsewhere(after)) {
      before = columns_[after].bed_previous;
    } else {
      after = columns_[before].bed_next;
    }
    c.bed_next = after;
    c.bed_previous = before;
    columns_[before].bed_next = columns_[after].bed_previous = column;
  }
  reading.emplace(c.key, column);
  refresh_turn(c.bed_previous);
  refresh_turn(c.bed_next);
  refresh_turn(column);
  refresh_place(read_previous(c.bed, c.key));
  refresh_place(column);
}

void TubeOrder::unhang(int column) {
  Column& c = columns_[column];
  reading_[side(c.bed)].erase(c.key);
  if (c.misplaced) --misplaced_;
  if (c.turn) --turns_[side(c.bed)];
  c.misplaced = c.turn = false;
  const int before = c.bed_previous;
  const int after = c.bed_next;
  c.bed_next = c.bed_previous = -1;
  if (before != column) {
    columns_[before].bed_next = after;
    columns_[after].bed_previous = before;
    refresh_turn(before);
    refresh_turn(after);
  }
  const int reader = read_previous(c.bed, c.key);
  if (reader >= 0) refresh_place(reader);
}

void TubeOrder::refresh_place(int column) {
  Column& c = columns_[column];
  const bool misplaced = read_next(c.bed, c.key) != c.next;
  misplaced_ += static_cast<int>(misplaced) - static_cast<int>(c.misplaced);
  c.misplaced = misplaced;
}

void TubeOrder::refresh_turn(int column) {
  Column& c = columns_[column];
  const bool came_up = c.key > columns_[c.bed_previous].key;
  const bool goes_up = columns_[c.bed_next].key > c.key;
  const bool turn = came_up != goes_up;
  turns_[side(c.bed)] += static_cast<int>(turn) - static_cast<int>(c.turn);
  c.turn = turn;
}

}  // namespace meshknit
