#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "meshknit/core/error.h"
#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/knitout/knitout_writer.h"

namespace meshknit {
namespace {

Instruction make(Op op) {
  Instruction i;
  i.op = op;
  switch (op) {
    case Op::rack:
      i.racking = -0.75;
      break;
    case Op::split:
    case Op::xfer:
      i.target = {Bed::back, 9, false};
      [[fallthrough]];
    case Op::drop:
    case Op::amiss:
      i.needle = {Bed::front, 11, true};
      break;
    case Op::knit:
    case Op::tuck:
    case Op::miss:
      i.needle = {Bed::back, 10, false};
      break;
    case Op::extension:
      i.text = "x-presser-mode auto";
      break;
    default:
      break;
  }
  const bool bare = op == Op::rack || op == Op::xfer || op == Op::drop || op == Op::amiss ||
                    op == Op::pause || op == Op::extension;
  if (!bare) i.carriers = {"2", "10"};
  if (op == Op::knit || op == Op::tuck || op == Op::split || op == Op::miss)
    i.direction = Side::left;
  return i;
}

Program every_operation() {
  Program p;
  p.headers = {{"Machine", "SWG091N2"}, {"Position", "Keep"}, {"Yarn-2", "30/2 red: wool"}};
  p.carriers = {"1", "2", "10"};
  for (const Op op :
       {Op::in, Op::out, Op::inhook, Op::releasehook, Op::outhook, Op::rack, Op::knit, Op::tuck,
        Op::split, Op::drop, Op::amiss, Op::xfer, Op::miss, Op::pause, Op::extension}) {
    p.instructions.push_back(make(op));
  }
  Instruction size = make(Op::extension);
  size.text = "stitch 55 -2.5";
  p.instructions.push_back(size);
  p.instructions[6].source = {Source::Kind::stitch, 2147483647};
  p.instructions[7].source = {Source::Kind::waste, -1};
  p.instructions[8].source = {Source::Kind::anchor, -1};
  return p;
}

void expect_same(const Program& a, const Program& b) {
  EXPECT_EQ(a.headers, b.headers);
  EXPECT_EQ(a.carriers, b.carriers);
  ASSERT_EQ(a.instructions.size(), b.instructions.size());
  for (std::size_t k = 0; k < a.instructions.size(); ++k) {
    const Instruction& x = a.instructions[k];
    const Instruction& y = b.instructions[k];
    EXPECT_EQ(x.op, y.op) << k;
    EXPECT_EQ(x.direction, y.direction) << k;
    EXPECT_EQ(x.needle, y.needle) << k;
    EXPECT_EQ(x.target, y.target) << k;
    EXPECT_EQ(x.carriers, y.carriers) << k;
    EXPECT_EQ(x.racking, y.racking) << k;
    EXPECT_EQ(x.text, y.text) << k;
    EXPECT_EQ(x.source.kind, y.source.kind) << k;
    EXPECT_EQ(x.source.stitch, y.source.stitch) << k;
  }
}

TEST(KnitoutRoundTrip, EveryOperationComesBack) {
  const Program program = every_operation();
  const std::string text = write_knitout(program);
  const KnitoutText back = read_knitout(text);
  for (const Problem& p : back.problems) ADD_FAILURE() << p.message;
  expect_same(program, back.program);
  EXPECT_EQ(write_knitout(back.program), text);
}

TEST(KnitoutRoundTrip, KeepsToTheStyleThatEveryReaderTakes) {
  Program program;
  program.carriers = {"1"};
  for (const double racking : {0.0, 1.0, 1.0, -0.75, 0.0}) {
    Instruction i;
    i.op = Op::rack;
    i.racking = racking;
    program.instructions.push_back(i);
  }
  // The racking starts at 0; only changes are written, without plus signs or trailing zeros.
  EXPECT_EQ(write_knitout(program), ";!knitout-2\n;;Carriers: 1\nrack 1\nrack -0.75\nrack 0\n");
}

TEST(KnitoutRoundTrip, WhatNoReaderTakesIsNotWritten) {
  const Program good = every_operation();
  const auto refused = [&](auto&& damage) {
    Program bad = good;
    damage(bad);
    EXPECT_THROW(write_knitout(bad), InvalidInput);
  };
  refused([](Program& p) { p.carriers.clear(); });
  refused([](Program& p) { p.carriers.push_back("a b"); });
  refused([](Program& p) { p.headers.push_back({"Carriers", "1"}); });
  refused([](Program& p) { p.headers.push_back({"Note", "two\nlines"}); });
  refused([](Program& p) { p.headers.push_back({"Position", "Middle"}); });
  refused([](Program& p) { p.instructions[6].needle.index = 0; });
  refused([](Program& p) { p.instructions[6].carriers = {"7"}; });
  refused([](Program& p) { p.instructions[6].carriers = {"2", "2"}; });
  refused([](Program& p) { p.instructions[0].carriers.clear(); });
  refused([](Program& p) { p.instructions[9].carriers = {"2"}; });
  refused([](Program& p) { p.instructions[5].racking = 1e300; });
  refused([](Program& p) { p.instructions[6].source = {Source::Kind::stitch, -1}; });
  refused([](Program& p) { p.instructions[14].text = "knit + f1 1"; });
  refused([](Program& p) { p.instructions[14].text = "x-a ; b"; });
  refused([](Program& p) { p.instructions[14].text = "x-a\ndrop f1"; });
}

// A fixed generator of our own, so that every run sees the same damage.
class Lcg {
 public:
  std::uint32_t below(std::uint32_t n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state_ >> 33) % n;
  }

 private:
  std::uint64_t state_ = 2018;
};

TEST(KnitoutRoundTrip, DamagedTextIsReadWithoutThrowingAndWhatWasReadIsStable) {
  const std::string good = write_knitout(every_operation());
  const std::string spice = "+-;:! \t\n\rfbsx0129.\xC3\xA9\xFF";
  Lcg random;
  for (int round = 0; round < 20000; ++round) {
    std::string text = good;
    const std::uint32_t wounds = 1 + random.below(6);
    for (std::uint32_t w = 0; w < wounds && !text.empty(); ++w) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
      switch (random.below(4)) {
        case 0:
          text[at] = spice[random.below(static_cast<std::uint32_t>(spice.size()))];
          break;
        case 1:
          text.erase(at, 1 + random.below(8));
          break;
        case 2:
          text.insert(at, 1, spice[random.below(static_cast<std::uint32_t>(spice.size()))]);
          break;
        default:
          text.insert(at,
                      text.substr(random.below(static_cast<std::uint32_t>(text.size())), 12));
          break;
      }
    }
    const KnitoutText read = read_knitout(text);
    for (const Problem& p : read.problems) {
      ASSERT_FALSE(p.code.empty() || p.message.empty() || p.remedy.empty());
    }
    // Whatever was understood and can be written comes back as it is.
    std::string written;
    try {
      written = write_knitout(read.program);
    } catch (const InvalidInput&) {
      continue;  // negative needles and the like can be read but not written
    }
    const KnitoutText again = read_knitout(written);
    ASSERT_FALSE(has_errors(again.problems)) << text;
    ASSERT_EQ(write_knitout(again.program), written);
  }
}

}  // namespace
}  // namespace meshknit
