// Good programs with one line changed: what alters the fabric or breaks a rule of the machine must
// be refused. Whether it does is judged by plain_machine, which shares nothing with the check.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "branching_graphs.h"
#include "graphs.h"
#include "meshknit/pipeline/pipeline.h"
#include "meshknit/tracing/trace.h"
#include "shapes.h"
#include "verify/in_place_knitter.h"
#include "verify/plain_machine.h"
#include "verify/worked_example.h"

namespace meshknit {
namespace {

// A fixed generator of our own, so that every run sees the same changes.
class Lcg {
 public:
  explicit Lcg(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33) % n;
  }

 private:
  std::uint64_t state_;
};

struct GoodProgram {
  std::string name;
  std::vector<std::string> lines;
  StitchTrace trace;
  MachineProfile machine = machine_profile("shima_swg091n2");
};

GoodProgram knitted(const std::string& shape, double size) {
  const MachineProfile profile = machine_profile("shima_swg091n2");
  const TimedShape timed = shape_named(shape, size);
  GoodProgram good;
  good.name = shape;
  good.trace = build_trace(build_knit_graph(timed.surface, timed.time, {}).graph, profile);
  const Schedule schedule = build_schedule(good.trace, profile);
  good.lines = KnitoutLines(build_knitout(good.trace, schedule, profile).text).lines();
  return good;
}

// A tube that parts into three, side by side, with three yarns.
GoodProgram three_legs() {
  GoodProgram good;
  good.name = "three legs";
  good.trace = trace_knit_graph(three_way_split(4, 2, 4, 2));
  std::vector<Needle> needles = back_places(10, 2);
  for (const auto& part : {front_places(10, 6), back_places(12, 4)}) {
    needles.insert(needles.end(), part.begin(), part.end());
  }
  good.lines = knit_in_place(good.trace, {needles});
  return good;
}

// From a graph by the scheduler, with little waste, so that most changes hit the object.
GoodProgram scheduled(const std::string& name, const KnitGraph& graph) {
  GoodProgram good;
  good.name = name;
  good.machine.waste_rounds = 2;
  good.trace = build_trace(graph, good.machine);
  const Schedule schedule = build_schedule(good.trace, good.machine);
  good.lines = KnitoutLines(build_knitout(good.trace, schedule, good.machine).text).lines();
  return good;
}

// A tube that had to be cut: it ends on the bed between others, and starts anew.
KnitGraph sewn() {
  const KnitGraph graph = crossed_pairs(4, 2, true);
  return cut_along(graph, plan_seams(graph).seams);
}

// A tube with a hole on the other machine, with so little waste that most changes
// hit the object.
GoodProgram hole_on_the_kniterate() {
  GoodProgram good;
  good.name = "a hole on the Kniterate";
  good.machine = machine_profile("kniterate");
  good.machine.waste_rounds = 2;
  good.machine.take_down_rounds = good.machine.take_down_width = 0;
  good.machine.draw_carrier.clear();
  good.trace = build_trace(tube_with_hole(5, 6, 3), good.machine);
  const Schedule schedule = build_schedule(good.trace, good.machine);
  good.lines = KnitoutLines(build_knitout(good.trace, schedule, good.machine).text).lines();
  return good;
}

const std::vector<GoodProgram>& good_programs() {
  const MachineProfile shima = machine_profile("shima_swg091n2");
  static const std::vector<GoodProgram> all = {
      {"worked example", KnitoutLines().lines(), worked_trace(), shima},
      {"branches", KnitoutLines::branches().lines(), branches_trace(), shima},
      three_legs(),
      knitted("bent_tube", 0.3),
      knitted("sock", 0.3),
      hole_on_the_kniterate(),
      scheduled("trousers", splitting_tube(7)),
      scheduled("a split and a merge", tube_with_hole(5, 6, 3)),
      scheduled("a seam", sewn())};
  return all;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string line_of(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

bool is_needle(const std::string& word) {
  return word.size() > 1 && (word[0] == 'f' || word[0] == 'b') &&
         (std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == 's');
}

// Changes one line, or two that change places. False if this line does not have what is to be
// changed.
class Mutation {
 public:
  Mutation(std::vector<std::string>& lines, Lcg& random) : lines_(lines), random_(random) {}

  std::string name;

  bool apply() {
    const std::size_t at = random_.below(lines_.size());
    if (lines_[at].empty() || lines_[at][0] == ';') return false;
    const std::string before = lines_[at];
    switch (random_.below(8)) {
      case 0:
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at));
        name = "dropped: " + before;
        return true;
      case 1:
        return change(at, is_needle, [&](std::string& needle) { move_needle(needle); });
      case 2: {
        const std::size_t other = std::min(at + 1 + random_.below(6), lines_.size() - 1);
        name = "swapped: " + before + " / " + lines_[other];
        std::swap(lines_[at], lines_[other]);
        return lines_[at] != lines_[other];
      }
      case 3:
        return before.rfind("rack", 0) == 0 &&
               change(
                   at, [](const std::string& w) { return w != "rack"; },
                   [&](std::string& racking) { shift_racking(racking); });
      case 4:
        return change(
            at, [](const std::string& w) { return w.size() <= 2 && std::atoi(w.c_str()); },
            [&](std::string& carrier) {
              const int now = std::atoi(carrier.c_str());
              carrier = std::to_string(1 + (now + static_cast<int>(random_.below(9))) % 10);
            });
      case 5:
        return change(
            at, [](const std::string& w) { return w == "+" || w == "-"; },
            [](std::string& side) { side = side == "+" ? "-" : "+"; });
      case 6:
        name = "removed: " + before;
        if (before.find("hook") == std::string::npos) return false;
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at));
        return true;
      default:
        name = "twice: " + before;
        lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(at), before);
        return true;
    }
  }

 private:
  template <class Fits, class Change>
  bool change(std::size_t at, Fits fits, Change&& act) {
    std::vector<std::string> words = words_of(lines_[at]);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < words.size() && words[k][0] != ';'; ++k) {
      if (fits(words[k])) places.push_back(k);
    }
    if (places.empty()) return false;
    act(words[places[random_.below(places.size())]]);
    const std::string now = line_of(words);
    name = "changed: " + lines_[at] + " -> " + now;
    const bool changed = now != lines_[at];
    lines_[at] = now;
    return changed;
  }

  void move_needle(std::string& needle) {
    const std::size_t digits = needle[1] == 's' ? 2 : 1;
    const int steps[] = {-3, -2, -1, 1, 2, 3};
    const std::size_t way = random_.below(8);
    if (way < 6) {
      const int number = std::atoi(needle.c_str() + digits) + steps[way];
      needle = needle.substr(0, digits) + std::to_string(number);
    } else if (way == 6) {
      needle[0] = needle[0] == 'f' ? 'b' : 'f';
    } else if (digits == 1) {
      needle.insert(1, "s");
    }
  }

  void shift_racking(std::string& racking) {
    const char* const shifts[] = {"-2", "-1", "0", "1", "2", "3", "0.25", "5"};
    racking = shifts[random_.below(8)];
  }

  std::vector<std::string>& lines_;
  Lcg& random_;
};

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(Mutations, WhatAltersTheFabricOrBreaksARuleIsRefused) {
  const std::size_t wanted[] = {500, 800, 400, 150, 150, 500, 800, 800, 400};
  int slipped = 0, harmful = 0, harmless_refused = 0, harmless = 0;
  for (std::size_t p = 0; p < good_programs().size(); ++p) {
    const GoodProgram& good = good_programs()[p];
    const PlainKnitting meant = knit_plainly(good.lines);
    ASSERT_EQ(meant.broken_rule, "") << good.name;
    Lcg random(p + 1);
    for (std::size_t tried = 0; tried < wanted[p];) {
      std::vector<std::string> lines = good.lines;
      Mutation mutation(lines, random);
      if (!mutation.apply()) continue;
      ++tried;
      const PlainKnitting made = knit_plainly(lines);
      const bool refused = !verify_knitout(text_of(lines), good.machine, good.trace).ok;
      if (!made.broken_rule.empty() || made.fabric != meant.fabric) {
        ++harmful;
        if (refused) continue;
        ++slipped;
        ADD_FAILURE() << good.name << ", " << mutation.name << " passes; " << made.broken_rule;
      } else {
        ++harmless;
        harmless_refused += refused;
      }
    }
  }
  std::cout << "mutations: " << harmful << " harmful, of which " << slipped << " passed; "
            << harmless << " harmless, of which " << harmless_refused << " were refused\n";
  // 4,500 in all, and most of them do harm.
  EXPECT_EQ(harmful + harmless, 4500);
  EXPECT_GT(harmful, 2000);
}

}  // namespace
}  // namespace meshknit
