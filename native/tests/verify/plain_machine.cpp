#include "verify/plain_machine.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

namespace meshknit {
namespace {

struct PlainLoop {
  int yarn = 0, before = -1, after = -1;
  std::string needle;
  std::string kind;  // object, waste or anchor
  bool held = true;
  int dropped_at = 0;
  double slack = 0;
  int number = -1;  // of the object's loops on its yarn
  std::string row;  // what it is in the fabric
};

struct PlainYarn {
  int out_at = 0, object_loops = 0;
  int rank = -1;  // of the yarns that knit the object
};

struct PlainCarrier {
  bool in = false, stitched = false, hooked = false;
  int yarn = -1, last = -1;
};

class PlainMachine {
 public:
  PlainKnitting run(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      ++at_;
      if (line == ";;Machine: Kniterate") kniterate_ = true;
      if (line.empty() || line[0] == ';') continue;
      const std::size_t comment = line.find(';');
      kind_ = "none";
      for (const char* kind : {"stitch", "waste", "anchor"}) {
        if (line.find(std::string("source: ") + kind) != std::string::npos) kind_ = kind;
      }
      std::istringstream words(line.substr(0, comment));
      std::vector<std::string> w;
      for (std::string word; words >> word;) w.push_back(word);
      if (!w.empty()) operate(w);
    }
    finish();
    PlainKnitting result;
    result.broken_rule = broken_;
    for (int rank = 0; rank < ranks_; ++rank) {
      for (const PlainLoop& loop : loops_) {
        if (loop.number >= 0 && yarns_[loop.yarn].rank == rank)
          result.fabric.push_back(loop.row);
      }
      result.fabric.push_back("next yarn");
    }
    return result;
  }

 private:
  void rule(bool kept, const std::string& what) {
    if (!kept && broken_.empty()) broken_ = what + " in line " + std::to_string(at_);
  }

  static char bed(const std::string& needle) { return needle[0]; }
  static bool slider(const std::string& needle) { return needle[1] == 's'; }
  static double number(const std::string& needle) {
    return std::atof(needle.c_str() + (slider(needle) ? 2 : 1));
  }
  double place(const std::string& needle) const {
    return number(needle) + (bed(needle) == 'b' ? racking_ : 0);
  }
  void exists(const std::string& needle) {
    rule(number(needle) >= 1 && number(needle) <= (kniterate_ ? 252 : 540),
         "needle outside the bed");
    rule(!kniterate_ || !slider(needle), "no sliders");
  }

  void operate(const std::vector<std::string>& w) {
    const std::string& op = w[0];
    rule(!kniterate_ || op.find("hook") == std::string::npos, "no hook");
    if (op == "rack") {
      racking_ = std::atof(w[1].c_str());
      const double fraction = racking_ - std::floor(racking_);
      rule(std::abs(racking_) <= 4 && (fraction == 0 || fraction == (kniterate_ ? 0.5 : 0.25)),
           "racking");
      for (const PlainLoop& loop : loops_) check_stretch(loop);
    } else if (op == "inhook" || op == "in") {
      PlainCarrier& c = carriers_[w[1]];
      rule(!c.in, "carrier in already");
      if (op == "inhook") rule(hook_.empty(), "hook holds another yarn");
      if (op == "inhook") hook_ = w[1];
      hook_parked_ = false;
      c = {true, false, op == "inhook", static_cast<int>(yarns_.size()), -1};
      yarns_.emplace_back();
    } else if (op == "outhook" || op == "out") {
      PlainCarrier& c = carriers_[w[1]];
      rule(c.in && c.stitched, "carrier out that is not in or has no stitch");
      rule(hook_.empty() || (op == "out" && hook_ != w[1]), "hook holds a yarn");
      if (c.in) yarns_[c.yarn].out_at = at_;
      c.in = false;
    } else if (op == "releasehook") {
      rule(hook_ == w[1] && hook_parked_, "release of a yarn that the hook does not hold");
      hook_.clear();
    } else if (op == "xfer") {
      hand_over(w[1], w[2]);
    } else if (op == "drop") {
      exists(w[1]);
      for (const int id : needles_[w[1]]) {
        loops_[id].held = false;
        loops_[id].dropped_at = at_;
        loops_[id].row += ", ends";
      }
      needles_[w[1]].clear();
    } else if (op == "knit" || op == "tuck") {
      make(op, w[1], w[2], w[3]);
    }
  }

  void hand_over(const std::string& from, const std::string& to) {
    exists(from);
    exists(to);
    rule(bed(from) != bed(to) && !(slider(from) && slider(to)), "transfer within a bed");
    rule(place(from) == place(to) && racking_ == std::floor(racking_), "transfer not aligned");
    std::vector<int>& source = needles_[from];
    std::vector<int>& target = needles_[to];
    rule(!source.empty(), "transfer from an empty needle");
    rule(!slider(to) || target.empty(), "two loops on a slider");
    if (from == to) return;
    for (const int id : source) {
      loops_[id].needle = to;
      target.push_back(id);
    }
    rule(target.size() <= 3, "stack");
    std::vector<int> moved;
    moved.swap(source);
    for (const int id : moved) {
      check_stretch(loops_[id]);
      if (loops_[id].after >= 0) check_stretch(loops_[loops_[id].after]);
    }
  }

  void check_stretch(const PlainLoop& loop) {
    if (loop.before < 0 || !loop.held || !loops_[loop.before].held) return;
    const double far = std::abs(place(loop.needle) - place(loops_[loop.before].needle));
    rule(far <= std::max(5.0, loop.slack), "stretched yarn");
  }

  void make(const std::string& op, const std::string& side, const std::string& needle,
            const std::string& name) {
    exists(needle);
    rule(!slider(needle), "loop made on a slider");
    PlainCarrier& c = carriers_[name];
    rule(c.in, "carrier not in");
    if (!c.in) return;
    rule(hook_.empty() || !hook_parked_ || place(needle) <= hook_place_, "right of the hook");
    if (!c.stitched) rule((side == "-") != kniterate_, "first stitch the wrong way");
    if (c.hooked && !c.stitched) {
      hook_parked_ = true;
      hook_place_ = place(needle);
    }
    c.stitched = true;
    PlainLoop loop;
    loop.yarn = c.yarn;
    loop.before = c.last;
    loop.needle = needle;
    loop.kind = kind_;
    const int id = static_cast<int>(loops_.size());
    if (c.last >= 0) {
      loop.slack = std::abs(place(needle) - place(loops_[c.last].needle));
      rule(loop.slack <= 7, "long float");
      loops_[c.last].after = id;
    }
    describe(op, side, loop);
    std::vector<int>& stack = needles_[needle];
    if (op == "knit") {
      rule(!stack.empty() || kind_ != "stitch", "knit on an empty needle");
      for (const int below : stack) {
        loops_[below].held = false;
        if (kind_ != "stitch") loops_[below].row += ", ends";
      }
      stack.clear();
    }
    stack.push_back(id);
    rule(stack.size() <= 3, "stack");
    c.last = id;
    loops_.push_back(loop);
    check_stretch(loops_.back());
  }

  void describe(const std::string& op, const std::string& side, PlainLoop& loop) {
    if (kind_ != "stitch") return;
    PlainYarn& yarn = yarns_[loop.yarn];
    if (yarn.rank < 0) yarn.rank = ranks_++;
    loop.number = yarn.object_loops++;
    const bool turned =
        op == "tuck" && loop.before >= 0 && bed(loops_[loop.before].needle) != bed(loop.needle);
    const bool clockwise = (bed(loop.needle) == 'f') == (side == "-");
    loop.row = op + (turned ? " either way" : clockwise ? " clockwise" : " anticlockwise");
    // A tuck lies on loops, a knit goes through them; either way they are its place in the fabric.
    bool on_waste = false;
    for (const int below : needles_[loop.needle]) {
      const PlainLoop& under = loops_[below];
      if (under.number >= 0) {
        loop.row +=
            " " + std::to_string(yarns_[under.yarn].rank) + ":" + std::to_string(under.number);
      } else {
        if (under.kind == "anchor") loop.row += " anchor";
        on_waste = on_waste || under.kind == "waste";
      }
    }
    if (on_waste) loop.row += " waste";
  }

  void finish() {
    rule(hook_.empty(), "hook not released");
    for (const auto& entry : carriers_) rule(!entry.second.in, "carrier not out");
    for (const PlainLoop& loop : loops_) {
      rule(!loop.held, "loop left");
      if (loop.number < 0 || loop.dropped_at == 0) continue;
      const int out = yarns_[loop.yarn].out_at;
      rule(out > 0 && out < loop.dropped_at, "loop dropped while its yarn is in");
    }
  }

  std::vector<PlainLoop> loops_;
  std::vector<PlainYarn> yarns_;
  std::map<std::string, std::vector<int>> needles_;
  std::map<std::string, PlainCarrier> carriers_;
  std::string hook_, kind_, broken_;
  bool hook_parked_ = false, kniterate_ = false;
  double hook_place_ = 0, racking_ = 0;
  int at_ = 0, ranks_ = 0;
};

}  // namespace

PlainKnitting knit_plainly(const std::vector<std::string>& lines) {
  return PlainMachine().run(lines);
}

}  // namespace meshknit
