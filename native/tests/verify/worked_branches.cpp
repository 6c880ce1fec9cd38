#include <string>
#include <utility>
#include <vector>

#include "verify/worked_example.h"

namespace meshknit {
namespace {

// A tube of eight parts into two of four and is whole again. The tubes are f10 f12 b11 b13, with
// yarn 5, and f14 f16 b15 b17, with yarn 6, which joins in where 5 has left the round unfinished.
// The right tube stands one place further right for two rounds, so that there is room between.
constexpr const char* kBranches = R"(knit - f12 5 ;!source: stitch 14
knit - f10 5 ;!source: stitch 15
knit + b11 5 ;!source: stitch 16
knit + b13 5 ;!source: stitch 17
inhook 6
tuck - f21 6 ;!source: anchor
tuck - f19 6 ;!source: anchor
tuck + f20 6 ;!source: anchor
releasehook 6
knit + b15 6 ;!source: stitch 18
knit + b17 6 ;!source: stitch 19
drop f21
drop f19
drop f20
knit - f16 6 ;!source: stitch 20
knit - f14 6 ;!source: stitch 21
knit + b15 6 ;!source: stitch 22
knit + b17 6 ;!source: stitch 23
knit - f16 6 ;!source: stitch 24
knit - f14 6 ;!source: stitch 25
knit + b15 6 ;!source: stitch 26
knit + b17 6 ;!source: stitch 27
xfer f14 b14
xfer f16 b16
rack 2
xfer b14 f16
xfer b16 f18
rack 0
xfer b15 f15
xfer b17 f17
rack -2
xfer f15 b17
xfer f17 b19
rack 0
knit - f12 5 ;!source: stitch 28
knit - f10 5 ;!source: stitch 29
knit + b11 5 ;!source: stitch 30
knit + b13 5 ;!source: stitch 31
knit - f18 6 ;!source: stitch 32
knit - f16 6 ;!source: stitch 33
knit + b17 6 ;!source: stitch 34
knit + b19 6 ;!source: stitch 35
knit - f18 6 ;!source: stitch 36
knit - f16 6 ;!source: stitch 37
knit + b17 6 ;!source: stitch 38
knit + b19 6 ;!source: stitch 39
outhook 5
xfer f16 b16
xfer f18 b18
rack -2
xfer b16 f14
xfer b18 f16
rack 0
xfer b17 f17
xfer b19 f19
rack 2
xfer f17 b15
xfer f19 b17
rack 0
knit - f16 6 ;!source: stitch 40
knit - f14 6 ;!source: stitch 41
knit - f12 6 ;!source: stitch 42
knit - f10 6 ;!source: stitch 43
knit + b11 6 ;!source: stitch 44
knit + b13 6 ;!source: stitch 45
knit + b15 6 ;!source: stitch 46
knit + b17 6 ;!source: stitch 47
knit - f16 6 ;!source: stitch 48
knit - f14 6 ;!source: stitch 49
knit - f12 6 ;!source: stitch 50
knit - f10 6 ;!source: stitch 51
knit + b11 6 ;!source: stitch 52
knit + b13 6 ;!source: stitch 53
knit + b15 6 ;!source: stitch 54
knit + b17 6 ;!source: stitch 55
outhook 6
drop f16
drop f14
drop f12
drop f10
drop b11
drop b13
drop b15
drop b17
)";

}  // namespace

StitchTrace branches_trace() {
  StitchTrace trace;
  trace.yarns = 2;
  int yarn = 0;
  const auto round = [&](StitchKind kind, const std::vector<int>& parents) {
    for (const int parent : parents) {
      Stitch stitch;
      stitch.yarn = yarn;
      stitch.kind = kind;
      stitch.direction = Direction::clockwise;
      if (parent >= 0) {
        stitch.parents = {parent};
        trace.stitches[parent].children = {static_cast<int>(trace.stitches.size())};
      }
      trace.stitches.push_back(std::move(stitch));
    }
  };
  // 0-7: f16 f14 f12 f10 b11 b13 b15 b17. 8-13: again, but not yet over b15 and b17.
  round(StitchKind::start, {-1, -1, -1, -1, -1, -1, -1, -1});
  round(StitchKind::knit, {0, 1, 2, 3, 4, 5});
  // 14-17: the left tube, f12 f10 b11 b13.
  round(StitchKind::knit, {10, 11, 12, 13});
  // 18-19: the other yarn ends the round; 20-27: the right tube twice, f16 f14 b15 b17.
  yarn = 1;
  round(StitchKind::knit, {6, 7});
  round(StitchKind::knit, {8, 9, 18, 19});
  round(StitchKind::knit, {20, 21, 22, 23});
  // 28-31: left; 32-39: right, twice.
  yarn = 0;
  round(StitchKind::knit, {14, 15, 16, 17});
  yarn = 1;
  round(StitchKind::knit, {24, 25, 26, 27});
  round(StitchKind::knit, {32, 33, 34, 35});
  // 40-47: both, as in the first round; 48-55: the last round.
  round(StitchKind::knit, {36, 37, 28, 29, 30, 31, 38, 39});
  round(StitchKind::end, {40, 41, 42, 43, 44, 45, 46, 47});
  return trace;
}

KnitoutLines KnitoutLines::branches() { return KnitoutLines(first_rounds + kBranches); }

}  // namespace meshknit
