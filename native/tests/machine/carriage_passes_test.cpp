#include "meshknit/machine/carriage_passes.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace meshknit {
namespace {

Instruction knit(Side direction, Bed bed, int index, const std::string& carrier = "2") {
  Instruction i;
  i.op = Op::knit;
  i.direction = direction;
  i.needle = {bed, index, false};
  i.carriers = {carrier};
  return i;
}

Instruction move(Bed bed, int from, int to) {
  Instruction i;
  i.op = Op::xfer;
  i.needle = {bed, from, false};
  i.target = {opposite(bed), to, false};
  return i;
}

Instruction rack(double racking) {
  Instruction i;
  i.op = Op::rack;
  i.racking = racking;
  return i;
}

Instruction hook(Op op) {
  Instruction i;
  i.op = op;
  i.carriers = {"2"};
  return i;
}

ProgramCost cost_of(std::initializer_list<Instruction> instructions) {
  Program program;
  program.instructions = instructions;
  return measure_program(program, machine_profile("shima_swg091n2"));
}

std::vector<CarriagePass> kniterate_passes(std::initializer_list<Instruction> instructions) {
  Program program;
  program.instructions = instructions;
  return carriage_passes(program, machine_profile("kniterate"));
}

TEST(CarriagePasses, TheKniterateTransfersEverySecondLoopFirst) {
  const std::vector<CarriagePass> passes = kniterate_passes(
      {move(Bed::front, 10, 10), move(Bed::front, 14, 14), move(Bed::front, 12, 12)});
  ASSERT_EQ(passes.size(), 2u);
  EXPECT_EQ(passes[0].instructions, (std::vector<int>{0, 1}));  // from the left: 10 and 14
  EXPECT_EQ(passes[1].instructions, (std::vector<int>{2}));
  EXPECT_EQ(kniterate_passes({move(Bed::front, 10, 10)}).size(), 1u);
}

TEST(CarriagePasses, OneBedOfTheKniterateDoesNotTuckBesideKnits) {
  Instruction tuck = knit(Side::right, Bed::front, 12);
  tuck.op = Op::tuck;
  EXPECT_EQ(kniterate_passes({knit(Side::right, Bed::front, 10), tuck}).size(), 2u);
  EXPECT_EQ(cost_of({knit(Side::right, Bed::front, 10), tuck}).passes, 1);
  // On the other bed it may.
  tuck.needle = {Bed::back, 13, false};
  EXPECT_EQ(kniterate_passes({knit(Side::right, Bed::front, 10), tuck}).size(), 1u);
}

TEST(CarriagePasses, ATubeRoundIsTwoPasses) {
  const ProgramCost cost =
      cost_of({knit(Side::left, Bed::front, 14), knit(Side::left, Bed::front, 12),
               knit(Side::left, Bed::front, 10), knit(Side::right, Bed::back, 11),
               knit(Side::right, Bed::back, 13), knit(Side::right, Bed::back, 15)});
  EXPECT_EQ(cost.passes, 2);
  EXPECT_EQ(cost.operations, 6);
  EXPECT_EQ(cost.lowest_needle, 10);
  EXPECT_EQ(cost.highest_needle, 15);
  // Two passes turn twice (0.6 s each) and travel 5 needles each at 30 needles a second.
  EXPECT_NEAR(cost.estimated_minutes, (2 * 0.6 + 10 / 30.0) / 60.0, 1e-12);
}

TEST(CarriagePasses, GoingBackStartsAPassEvenInTheSameDirection) {
  EXPECT_EQ(
      cost_of({knit(Side::left, Bed::front, 10), knit(Side::left, Bed::front, 12)}).passes, 2);
}

TEST(CarriagePasses, ACarrierChangeStartsAPass) {
  EXPECT_EQ(
      cost_of({knit(Side::left, Bed::front, 12, "2"), knit(Side::left, Bed::front, 10, "3")})
          .passes,
      2);
}

TEST(CarriagePasses, OnePositionOnBothBedsSharesAPassOnlyAtQuarterPitch) {
  EXPECT_EQ(
      cost_of({knit(Side::right, Bed::front, 10), knit(Side::right, Bed::back, 10)}).passes, 2);
  EXPECT_EQ(
      cost_of({rack(0.25), knit(Side::right, Bed::front, 10), knit(Side::right, Bed::back, 10)})
          .passes,
      1);
}

TEST(CarriagePasses, TheBackNeedleStandsWhereRackingPutsIt) {
  // At rack 2 back needle 10 stands at 12: right of front needle 11.
  EXPECT_EQ(
      cost_of({rack(2), knit(Side::right, Bed::front, 11), knit(Side::right, Bed::back, 10)})
          .passes,
      1);
}

TEST(CarriagePasses, TransfersJoinByRackingAndWay) {
  // Over to the back (in any order), at another racking back again in two, each way its own
  // pass.
  const ProgramCost cost = cost_of({move(Bed::front, 10, 10), move(Bed::front, 14, 14),
                                    move(Bed::front, 12, 12), rack(2), move(Bed::back, 10, 12),
                                    move(Bed::back, 12, 14), rack(3), move(Bed::back, 14, 17)});
  EXPECT_EQ(cost.transfers, 6);
  EXPECT_EQ(cost.passes, 3);
  EXPECT_EQ(cost.max_racking, 3.0);
}

TEST(CarriagePasses, ReleasingTheHookCostsAnotherPassAfterALeftwardOne) {
  const Instruction left = knit(Side::left, Bed::front, 12);
  const Instruction right = knit(Side::right, Bed::front, 14);
  // left, right, release leftward; against left, come back, release leftward.
  EXPECT_EQ(cost_of({hook(Op::inhook), left, right, hook(Op::releasehook)}).passes, 3);
  EXPECT_EQ(cost_of({hook(Op::inhook), left, hook(Op::releasehook)}).passes, 3);
}

TEST(CarriagePasses, AnEmptyProgramCostsNothing) {
  const ProgramCost cost = cost_of({});
  EXPECT_EQ(cost.passes, 0);
  EXPECT_EQ(cost.estimated_minutes, 0.0);
}

}  // namespace
}  // namespace meshknit
