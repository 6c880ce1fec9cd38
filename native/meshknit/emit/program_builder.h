#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meshknit/machine/needle.h"
#include "meshknit/machine/program.h"
#include "meshknit/schedule/schedule.h"
#include "meshknit/tracing/stitch.h"

namespace meshknit {

/// Carriage travel that knits a bed in a direction round the tube (tracing/stitch.h).
Side travel(Bed bed, Direction direction);

/// The other way.
Side reverse(Side side);

/// The needle of a hook at half gauge.
Needle needle_of(const Hook& hook);

/// Writes a program operation by operation. Knows the racking: loops are made at racking 0,
/// transfers at theirs, and nothing is racked twice.
class ProgramBuilder {
 public:
  explicit ProgramBuilder(Program header) : program_(std::move(header)) {}

  /// in, inhook, releasehook, outhook or out.
  void carrier(Op op, const std::string& carrier);
  void knit(Side side, const Needle& needle, const std::string& carrier, const Source& source);
  void tuck(Side side, const Needle& needle, const std::string& carrier, const Source& source);
  void drop(const Needle& needle);
  /// Racks so that the needles, on opposite beds, face each other.
  void transfer(const Needle& from, const Needle& to);

  Program finish();

 private:
  void make_loop(Op op, Side side, const Needle& needle, const std::string& carrier,
                 const Source& source);
  void rack(int racking);

  Program program_;
  int racking_ = 0;
};

}  // namespace meshknit
