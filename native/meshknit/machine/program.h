#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meshknit/machine/needle.h"

namespace meshknit {

/// Knitout operations, with knitout's meaning (primer, section 2.1).
enum class Op {
  in,
  out,
  inhook,
  releasehook,
  outhook,
  rack,
  knit,
  tuck,
  split,
  drop,
  amiss,
  xfer,
  miss,
  pause,
  extension
};

enum class Side { left, right };  ///< carriage travel: left is knitout's '-', right is '+'

/// Where an operation comes from: a traced stitch (>= 0), waste, an anchor, or nothing to name.
struct Source {
  enum class Kind { none, stitch, waste, anchor } kind = Kind::none;
  int stitch = -1;
};

struct Instruction {
  Op op = Op::pause;
  Side direction = Side::right;       ///< knit, tuck, split, miss
  Needle needle;                      ///< all needle operations
  Needle target;                      ///< split, xfer
  std::vector<std::string> carriers;  ///< in, out, hooks, knit, tuck, split, miss
  double racking = 0.0;               ///< rack
  std::string text;  ///< extension (x-... or "stitch L T"): the line without comment, one space
                     ///< between words
  Source source;
  int line = 0;  ///< in a file that was read, from 1
};

/// A machine program: headers in order, then instructions. An operation without a carrier is
/// named by what it does (drop, amiss, xfer), not by its synonym. The racking is 0 at the
/// start.
struct Program {
  std::vector<std::pair<std::string, std::string>> headers;  ///< without "Carriers"
  std::vector<std::string> carriers;
  std::vector<Instruction> instructions;
};

}  // namespace meshknit
