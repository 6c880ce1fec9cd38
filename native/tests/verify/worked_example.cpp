#include "verify/worked_example.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace meshknit {
const std::string first_rounds = R"(;!knitout-2
;;Carriers: 1 2 3 4 5 6 7 8 9 10
;;Machine: SWG091N2
;;Position: Keep
inhook 5
tuck - f16 5 ;!source: anchor
tuck - f12 5 ;!source: anchor
tuck + f14 5 ;!source: anchor
releasehook 5
knit - f16 5 ;!source: waste
knit - f12 5 ;!source: waste
tuck + b11 5 ;!source: waste
tuck + b15 5 ;!source: waste
knit - f14 5 ;!source: waste
tuck - f10 5 ;!source: waste
tuck + b13 5 ;!source: waste
tuck + b17 5 ;!source: waste
knit - f16 5 ;!source: stitch 0
knit - f14 5 ;!source: stitch 1
knit - f12 5 ;!source: stitch 2
knit - f10 5 ;!source: stitch 3
knit + b11 5 ;!source: stitch 4
knit + b13 5 ;!source: stitch 5
knit + b15 5 ;!source: stitch 6
knit + b17 5 ;!source: stitch 7
knit - f16 5 ;!source: stitch 8
knit - f14 5 ;!source: stitch 9
knit - f12 5 ;!source: stitch 10
knit - f10 5 ;!source: stitch 11
knit + b11 5 ;!source: stitch 12
knit + b13 5 ;!source: stitch 13
)";

namespace {

// The primer's section 6, one operation a line. Front loops on f10 to f16, back loops on b11 to
// b17.
constexpr const char* kRest = R"(knit + b15 5 ;!source: stitch 14
knit + b17 5 ;!source: stitch 15
xfer f10 b10
rack 2
xfer b10 f12
rack 0
knit - f16 5 ;!source: stitch 16
knit - f14 5 ;!source: stitch 17
knit - f12 5 ;!source: stitch 18
knit + b11 5 ;!source: stitch 19
knit + b13 5 ;!source: stitch 20
knit + b15 5 ;!source: stitch 21
knit + b17 5 ;!source: stitch 22
knit - f16 5 ;!source: stitch 23
knit - f14 5 ;!source: stitch 24
knit - f12 5 ;!source: stitch 25
tuck - b11 5 ;!source: stitch 26
knit + f12 5 ;!source: stitch 27
knit + f14 5 ;!source: stitch 28
knit + f16 5 ;!source: stitch 29
tuck + b17 5 ;!source: stitch 30
knit - f16 5 ;!source: stitch 31
knit - f14 5 ;!source: stitch 32
knit - f12 5 ;!source: stitch 33
knit + b11 5 ;!source: stitch 34
knit + b13 5 ;!source: stitch 35
knit + b15 5 ;!source: stitch 36
knit + b17 5 ;!source: stitch 37
knit - f16 5 ;!source: stitch 38
knit - f14 5 ;!source: stitch 39
knit - f12 5 ;!source: stitch 40
tuck + f10 5 ;!source: stitch 40
knit + b11 5 ;!source: stitch 41
knit + b13 5 ;!source: stitch 42
knit + b15 5 ;!source: stitch 43
knit + b17 5 ;!source: stitch 44
knit - f16 5 ;!source: stitch 45
knit - f14 5 ;!source: stitch 46
knit - f12 5 ;!source: stitch 47
knit - f10 5 ;!source: stitch 48
knit + b11 5 ;!source: stitch 49
knit + b13 5 ;!source: stitch 50
knit + b15 5 ;!source: stitch 51
knit + b17 5 ;!source: stitch 52
outhook 5
drop f16
drop f14
drop f12
drop f10
drop b11
drop b13
drop b15
drop b17
)";

// Adds a stitch and enters it as the next child of its parents.
int add(StitchTrace& trace, StitchKind kind, Direction direction, std::vector<int> parents) {
  const int index = static_cast<int>(trace.stitches.size());
  for (const int p : parents) trace.stitches[p].children.push_back(index);
  Stitch stitch;
  stitch.kind = kind;
  stitch.direction = direction;
  stitch.parents = std::move(parents);
  trace.stitches.push_back(std::move(stitch));
  return index;
}

}  // namespace

StitchTrace worked_trace() {
  StitchTrace trace;
  trace.yarns = 1;
  const auto clockwise = [&](StitchKind kind, std::vector<int> parents) {
    add(trace, kind, Direction::clockwise, std::move(parents));
  };
  const auto anticlockwise = [&](StitchKind kind, std::vector<int> parents) {
    add(trace, kind, Direction::anticlockwise, std::move(parents));
  };
  // 0-7, 8-15: two plain rounds: f16 f14 f12 f10 b11 b13 b15 b17.
  for (int k = 0; k < 8; ++k) clockwise(StitchKind::start, {});
  for (int k = 0; k < 8; ++k) clockwise(StitchKind::knit, {k});
  // 16-22: f10 has joined f12.
  clockwise(StitchKind::knit, {8});
  clockwise(StitchKind::knit, {9});
  clockwise(StitchKind::decrease, {10, 11});
  for (int k = 12; k < 16; ++k) clockwise(StitchKind::knit, {k});
  // 23-26: short row over the front, anchored on b11 (19); 27-30: back again, anchored on b17
  // (22).
  for (int k = 16; k < 19; ++k) clockwise(StitchKind::knit, {k});
  clockwise(StitchKind::tuck, {});
  for (int k = 25; k > 22; --k) anticlockwise(StitchKind::knit, {k});
  anticlockwise(StitchKind::tuck, {});
  // 31-37: a round that picks up both tucks.
  for (int k = 29; k > 26; --k) clockwise(StitchKind::knit, {k});
  clockwise(StitchKind::knit, {19, 26});
  clockwise(StitchKind::knit, {20});
  clockwise(StitchKind::knit, {21});
  clockwise(StitchKind::knit, {22, 30});
  // 38-44: f12 (40) makes a second loop on f10.
  clockwise(StitchKind::knit, {31});
  clockwise(StitchKind::knit, {32});
  clockwise(StitchKind::increase, {33});
  for (int k = 34; k < 38; ++k) clockwise(StitchKind::knit, {k});
  // 45-52: the last round.
  for (const int parent : {38, 39, 40, 40, 41, 42, 43, 44})
    clockwise(StitchKind::end, {parent});
  return trace;
}

KnitoutLines::KnitoutLines() : KnitoutLines(first_rounds + kRest) {}

KnitoutLines::KnitoutLines(std::string text) {
  for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos;) {
    lines_.push_back(text.substr(0, end));
    text.erase(0, end + 1);
  }
}

std::string KnitoutLines::text() const {
  std::string text;
  for (const std::string& line : lines_) text += line + "\n";
  return text;
}

int KnitoutLines::find(const std::string& part) const {
  const auto at = std::find_if(lines_.begin(), lines_.end(), [&](const std::string& line) {
    return line.find(part) != std::string::npos;
  });
  if (at == lines_.end()) throw std::logic_error("the example has no line with " + part);
  return static_cast<int>(at - lines_.begin());
}

KnitoutLines& KnitoutLines::remove(const std::string& part) {
  lines_.erase(lines_.begin() + find(part));
  return *this;
}

KnitoutLines& KnitoutLines::replace(const std::string& part, const std::string& with) {
  std::string& line = lines_[find(part)];
  line.replace(line.find(part), part.size(), with);
  return *this;
}

KnitoutLines& KnitoutLines::replace_all(const std::string& part, const std::string& with) {
  while (std::any_of(lines_.begin(), lines_.end(), [&](const std::string& line) {
    return line.find(part) != std::string::npos;
  })) {
    replace(part, with);
  }
  return *this;
}

KnitoutLines& KnitoutLines::before(const std::string& part, std::vector<std::string> added) {
  lines_.insert(lines_.begin() + find(part), added.begin(), added.end());
  return *this;
}

KnitoutLines& KnitoutLines::swap(const std::string& part, const std::string& other) {
  std::swap(lines_[find(part)], lines_[find(other)]);
  return *this;
}

}  // namespace meshknit
