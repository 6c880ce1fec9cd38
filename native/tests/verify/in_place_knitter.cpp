#include "verify/in_place_knitter.h"

#include <algorithm>
#include <set>

namespace meshknit {
namespace {

class InPlaceKnitter {
 public:
  InPlaceKnitter(const StitchTrace& trace, const std::vector<std::vector<Needle>>& rounds)
      : trace_(trace), rounds_(rounds), needle_of_(trace.stitches.size()) {
    for (int c = 2; c <= 10; ++c) free_.insert(c);
    for (std::size_t y = 0; y < static_cast<std::size_t>(trace.yarns); ++y) {
      first_.push_back(-1);
      last_.push_back(-1);
      carrier_.push_back(0);
    }
    for (int s = 0; s < static_cast<int>(trace.stitches.size()); ++s) {
      const int yarn = trace.stitches[s].yarn;
      if (first_[yarn] < 0) first_[yarn] = s;
      last_[yarn] = s;
    }
  }

  std::vector<std::string> run() {
    lines_ = {";!knitout-2", ";;Carriers: 1 2 3 4 5 6 7 8 9 10", ";;Machine: SWG091N2",
              ";;Position: Keep"};
    for (int s = 0; s < static_cast<int>(trace_.stitches.size()); ++s) make(s);
    for (const std::vector<Needle>& round : rounds_) {
      for (const Needle& needle : round) add("drop " + to_string(needle));
    }
    return lines_;
  }

 private:
  void add(const std::string& line) { lines_.push_back(line); }

  void loop(const std::string& op, Direction direction, const Needle& needle, int carrier,
            const std::string& source) {
    const bool rightward =
        (direction == Direction::anticlockwise) == (needle.bed == Bed::front);
    add(op + (rightward ? " + " : " - ") + to_string(needle) + " " + std::to_string(carrier) +
        " ;!source: " + source);
  }

  // Two tucks on empty front needles beside the first stitch.
  std::vector<std::string> bring_in(int carrier, const Needle& first) {
    const int left = first.index | 1;
    add("inhook " + std::to_string(carrier));
    std::vector<std::string> drops;
    for (const int index : {left + 2, left}) {
      const Needle needle{Bed::front, index, false};
      loop("tuck", Direction::clockwise, needle, carrier, "anchor");
      drops.push_back("drop " + to_string(needle));
    }
    add("releasehook " + std::to_string(carrier));
    return drops;
  }

  void cast_on_waste(const std::vector<Needle>& round) {
    std::vector<std::string> drops = bring_in(1, round[0]);
    for (const std::size_t begin : {0, 1}) {
      for (std::size_t k = begin; k < round.size(); k += 2) {
        loop("tuck", Direction::anticlockwise, round[k], 1, "waste");
      }
    }
    for (const std::string& drop : drops) add(drop);
    for (const Needle& needle : round) {
      loop("knit", Direction::anticlockwise, needle, 1, "waste");
    }
    add("outhook 1");
  }

  Needle needle_for(int s) {
    const Stitch& stitch = trace_.stitches[s];
    if (stitch.kind == StitchKind::tuck) {
      const std::vector<int>& under = trace_.stitches[stitch.children[0]].parents;
      return needle_of_[*(std::find(under.begin(), under.end(), s) - 1)];
    }
    if (stitch.kind != StitchKind::start) return needle_of_[stitch.parents[0]];
    if (place_ == 0) cast_on_waste(rounds_[round_]);
    const Needle needle = rounds_[round_][place_];
    if (++place_ == rounds_[round_].size()) {
      place_ = 0;
      ++round_;
    }
    return needle;
  }

  void make(int s) {
    const Stitch& stitch = trace_.stitches[s];
    const Needle needle = needle_of_[s] = needle_for(s);
    std::vector<std::string> drops;
    int& carrier = carrier_[stitch.yarn];
    if (first_[stitch.yarn] == s) {
      carrier = *free_.begin();
      free_.erase(free_.begin());
      drops = bring_in(carrier, needle);
    }
    loop(stitch.kind == StitchKind::tuck ? "tuck" : "knit", stitch.direction, needle, carrier,
         "stitch " + std::to_string(s));
    for (const std::string& drop : drops) add(drop);
    if (last_[stitch.yarn] != s) return;
    add("outhook " + std::to_string(carrier));
    free_.insert(carrier);
  }

  const StitchTrace& trace_;
  const std::vector<std::vector<Needle>>& rounds_;
  std::vector<std::string> lines_;
  std::vector<Needle> needle_of_;
  std::vector<int> first_, last_, carrier_;  // yarn -> stitches, carrier
  std::set<int> free_;
  std::size_t round_ = 0, place_ = 0;
};

}  // namespace

std::vector<std::string> knit_in_place(const StitchTrace& trace,
                                       const std::vector<std::vector<Needle>>& rounds) {
  return InPlaceKnitter(trace, rounds).run();
}

std::vector<Needle> front_places(int left, int count) {
  std::vector<Needle> needles;
  for (int k = left; k < left + count; ++k) {
    needles.push_back(half_gauge_needle({Bed::front, k, false}));
  }
  return needles;
}

std::vector<Needle> back_places(int left, int count) {
  std::vector<Needle> needles;
  for (int k = left + count - 1; k >= left; --k) {
    needles.push_back(half_gauge_needle({Bed::back, k, false}));
  }
  return needles;
}

}  // namespace meshknit
