#include "meshknit/verify/carrier_rules.h"

#include <algorithm>

namespace meshknit {

void CarrierRules::bring_in(const Instruction& i) {
  if (i.op == Op::inhook) {
    if (!profile_.has_inserting_hook) {
      log_.error("no-hook", i.line, "the machine has no inserting hook");
    }
    if (!hooked_.empty()) {
      log_.error("second-hook", i.line,
                 "the inserting hook still holds carrier " + hooked_.front() +
                     "; it can hold one yarn end");
    }
    hooked_ = i.carriers;
    hook_line_ = i.line;
    hook_parked_ = false;
  }
  for (const std::string& name : i.carriers) {
    Carrier& c = carrier(name);
    if (c.state != State::out) {
      log_.error("carrier-already-in", i.line, "carrier " + name + " is in already");
      continue;
    }
    c.state = State::pending;
    c.came_with = i.carriers;
    c.stitched = false;
    open_yarn(c, i.line);
  }
}

void CarrierRules::take_out(const Instruction& i) {
  if (i.op == Op::outhook) {
    if (!profile_.has_inserting_hook) {
      log_.error("no-hook", i.line, "the machine has no inserting hook");
    }
    if (!hooked_.empty()) {
      log_.error("hook-busy", i.line,
                 "the hook cannot take a yarn out while it holds carrier " + hooked_.front());
    }
  }
  for (const std::string& name : i.carriers) {
    Carrier& c = carrier(name);
    if (c.state == State::out) {
      log_.error("carrier-not-in", i.line, "carrier " + name + " is not in");
      continue;
    }
    if (!c.stitched) {
      log_.error("carrier-without-stitch", i.line,
                 "carrier " + name + " goes out without having made a stitch");
    }
    if (i.op == Op::out && hook_holds(name)) {
      log_.error("hook-busy", i.line,
                 "carrier " + name + " cannot go out while the hook holds its yarn");
    }
    c.state = State::out;
    if (c.yarn >= 0) fabric_.yarns[c.yarn].line_out = i.line;
  }
}

void CarrierRules::release(const Instruction& i) {
  if (!profile_.has_inserting_hook) {
    log_.error("no-hook", i.line, "the machine has no inserting hook");
  }
  if (hooked_.empty()) {
    log_.error("wrong-release", i.line, "the hook holds nothing that it could release");
  } else if (hooked_ != i.carriers) {
    log_.error("wrong-release", i.line,
               "the hook holds carrier " + hooked_.front() + ", not " + i.carriers.front());
  } else if (!hook_parked_) {
    log_.error("wrong-release", i.line, "no stitch has been made since the hook took the yarn");
  }
  hooked_.clear();
}

void CarrierRules::pass_by(const Instruction& i) {
  for (const std::string& name : i.carriers) {
    if (carrier(name).state == State::out) {
      log_.error("carrier-not-in", i.line, "carrier " + name + " is not in");
    }
  }
}

void CarrierRules::before_transfer(int line) {
  if (hooked_.empty()) return;
  log_.warning("transfer-before-release", line,
               "a loop is transferred while the hook holds carrier " + hooked_.front(), {},
               "Release the hook before any transfer.");
}

int CarrierRules::use(const Instruction& i, int position) {
  if (i.carriers.size() > 1) {
    log_.error("several-carriers", i.line,
               "one loop is made of several carriers; this check follows one a loop");
  }
  if (hook_parked_ && !hooked_.empty() && position > hook_position_) {
    log_.error("stitch-right-of-hook", i.line,
               to_string(i.needle) + " lies right of the hook, which holds carrier " +
                   hooked_.front() + " until it is released");
  }
  for (const std::string& name : i.carriers) {
    Carrier& c = carrier(name);
    if (c.state == State::out) {
      log_.error("carrier-not-in", i.line, "carrier " + name + " is not in");
      open_yarn(c, i.line);
    } else if (c.state == State::pending) {
      check_first_stitch(c, i, position);
    }
    c.state = State::active;
    c.stitched = true;
  }
  return carrier(i.carriers.front()).yarn;
}

void CarrierRules::check_first_stitch(Carrier& c, const Instruction& i, int position) {
  if (c.came_with != i.carriers) {
    log_.error("wrong-first-set", i.line,
               "carrier " + c.name + " came in with others and is used without them");
  }
  const Side first = profile_.first_stitch_leftward ? Side::left : Side::right;
  if (i.direction != first) {
    log_.error("first-stitch-direction", i.line,
               "the first stitch of carrier " + c.name + " must be made " +
                   (first == Side::left ? "leftward" : "rightward"));
  }
  if (hook_holds(c.name)) {
    hook_parked_ = true;
    hook_position_ = position;
  }
}

void CarrierRules::finish() {
  if (!hooked_.empty()) {
    log_.error("hook-not-released", hook_line_,
               "the hook still holds carrier " + hooked_.front() + " at the end of the file");
  }
  for (const Carrier& c : carriers_) {
    if (c.state == State::out) continue;
    const int line = c.yarn >= 0 ? fabric_.yarns[c.yarn].line_in : 0;
    log_.error("carrier-not-out", line,
               "carrier " + c.name + " is still in at the end of the file");
  }
}

CarrierRules::Carrier& CarrierRules::carrier(const std::string& name) {
  for (Carrier& c : carriers_) {
    if (c.name == name) return c;
  }
  Carrier c;
  c.name = name;
  carriers_.push_back(c);
  return carriers_.back();
}

int CarrierRules::open_yarn(Carrier& c, int line) {
  c.yarn = static_cast<int>(fabric_.yarns.size());
  Yarn yarn;
  yarn.carrier = c.name;
  yarn.line_in = line;
  fabric_.yarns.push_back(yarn);
  return c.yarn;
}

bool CarrierRules::hook_holds(const std::string& name) const {
  return std::find(hooked_.begin(), hooked_.end(), name) != hooked_.end();
}

}  // namespace meshknit
