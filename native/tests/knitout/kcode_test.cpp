// The Kniterate's own files: the sweeps that a program needs, and their text.

#include "meshknit/knitout/kcode.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/knitout/kcode_plan.h"
#include "meshknit/knitout/knitout_reader.h"

namespace meshknit {
namespace {

const MachineProfile& kniterate() {
  static const MachineProfile profile = machine_profile("kniterate");
  return profile;
}

Program program(const std::string& operations) {
  const KnitoutText read = read_knitout(";!knitout-2\n;;Carriers: 1 2 3 4 5 6\n" + operations);
  EXPECT_TRUE(read.problems.empty());
  return read.program;
}

std::vector<KcodePass> plan(const std::string& operations) {
  return plan_kcode(program(operations), kniterate());
}

using Needles = std::vector<int>;

TEST(Kcode, ACarrierComesFromItsParkingPlaceAndGoesBackToIt) {
  const std::vector<KcodePass> sweeps = plan(
      "in 2\ntuck + f100 2\ntuck + f102 2\nknit - f102 2\nknit - f100 2\nout 2\ndrop f100\n"
      "drop f102\n");
  // Right with two tucks, left with two knits; back right for nothing, left with the carrier alone,
  // right with two drops. Needle 100 is column 15 + 99 = 114, needle 102 column 116.
  ASSERT_EQ(sweeps.size(), 5u);
  for (std::size_t s = 0; s < sweeps.size(); ++s)
    EXPECT_EQ(sweeps[s].direction, s % 2 == 0 ? Side::right : Side::left);
  EXPECT_TRUE(sweeps[0].front_tucks);
  EXPECT_FALSE(sweeps[1].front_tucks);
  for (const int working : {0, 1, 4}) {
    EXPECT_EQ(sweeps[working].front, (Needles{100, 102}));
    EXPECT_TRUE(sweeps[working].rear.empty());
  }
  EXPECT_TRUE(sweeps[2].front.empty() && sweeps[3].front.empty());
  EXPECT_EQ(sweeps[0].carrier_left, 8);
  EXPECT_EQ(sweeps[0].carrier_right, 116 + 1 + 2);  // two columns past the needle
  EXPECT_EQ(sweeps[1].carrier_left, 114 - 2);
  EXPECT_EQ(sweeps[3].carrier_left, 8);
  EXPECT_EQ(sweeps[4].carrier, 0);
}

TEST(Kcode, TheCarriageTurnsWhereTheNextSweepBegins) {
  const std::vector<KcodePass> sweeps =
      plan("in 2\ntuck + f100 2\nknit - f100 2\nout 2\ndrop f40\ndrop f200\n");
  for (std::size_t s = 0; s + 1 < sweeps.size(); ++s) {
    if (sweeps[s].direction == Side::right)
      EXPECT_EQ(sweeps[s].carriage_right, sweeps[s + 1].carriage_right);
    else
      EXPECT_EQ(sweeps[s].carriage_left, sweeps[s + 1].carriage_left);
  }
}

TEST(Kcode, AStitchOutOfTurnFetchesTheCarrierFirst) {
  // After f102 going right the carrier is past it; a tuck on f104, going right again, is another
  // pass (other cams), for which it must come from the left.
  const std::vector<KcodePass> sweeps =
      plan("in 2\nknit + f100 2\nknit + f102 2\ntuck + f104 2\n");
  ASSERT_EQ(sweeps.size(), 3u);
  EXPECT_TRUE(sweeps[1].front.empty());
  EXPECT_EQ(sweeps[1].carrier, 2);
  EXPECT_EQ(sweeps[1].carrier_left, column_of(104) - 2);
  EXPECT_EQ(sweeps[2].front, Needles{104});
}

TEST(Kcode, AWaitingCarrierMakesWayToTheSideWhereItIsWantedNext) {
  // Carrier 2 waits past f102, above needles that 3 works; it goes on leftward, so it waits right.
  const std::vector<KcodePass> sweeps = plan(
      "in 2\nknit + f100 2\nknit + f102 2\nin 3\nknit + f96 3\nknit + f110 3\n"
      "knit - f102 2\n");
  const KcodePass* moved = nullptr;
  const KcodePass* work = nullptr;
  for (const KcodePass& sweep : sweeps) {
    if (sweep.carrier == 2 && sweep.front.empty() && !moved) moved = &sweep;
    if (sweep.carrier == 3) work = &sweep;
  }
  ASSERT_TRUE(moved && work && moved < work);
  EXPECT_GE(moved->carrier_right, column_of(110) + 1);
  // Carrier 3 stops beside it, no nearer than two columns.
  EXPECT_GE(std::abs(work->carrier_right - moved->carrier_right), kCarrierSpacing);
}

TEST(Kcode, TransfersGoInHalvesAtTheirRacking) {
  // b meets f = b + 2: f102, f104, f106 go to b100, b102, b104.
  const std::vector<KcodePass> sweeps =
      plan("rack 2\nxfer f102 b100\nxfer f104 b102\nxfer f106 b104\nrack 0\ndrop b100\n");
  ASSERT_EQ(sweeps.size(), 3u);
  EXPECT_EQ(sweeps[0].kind, KcodePass::Kind::front_to_back);
  EXPECT_EQ(sweeps[0].front, (Needles{102, 106}));
  EXPECT_EQ(sweeps[0].rear, (Needles{100, 104}));
  EXPECT_EQ(sweeps[1].front, Needles{104});
  EXPECT_EQ(sweeps[1].rear, Needles{102});
  EXPECT_EQ(sweeps[0].racking, 2.0);
  EXPECT_EQ(sweeps[2].racking, 0.0);
}

TEST(Kcode, ALineLooksAsThePrimerSays) {
  const std::vector<KcodePass> sweeps = plan(
      "x-stitch-number 6\nx-speed-number 300\nx-roller-advance 250\nin 3\nknit + f1 3\n"
      "knit + f3 3\n");
  ASSERT_EQ(sweeps.size(), 1u);
  const std::string text = write_kcode(sweeps, 252);
  // 15 dots with the carrier's start in front of column 8; needles 1 and 3, its stop two columns on;
  // 247 more needles, 15 dots.
  EXPECT_NE(text.find("\nFRNT:......../3.......-_-__3\\" + std::string(247, '_') +
                      std::string(15, '.') + "\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\nREAR:......../3......._____3\\" + std::string(247, '_')),
            std::string::npos);
  EXPECT_NE(text.find("\nSTIF:" + std::string(282, '6') + "\n"), std::string::npos);
  EXPECT_NE(text.find("\nSTIR:" + std::string(282, '0') + "\n"), std::string::npos);
  EXPECT_NE(text.find("\n>> Kn-Kn 3 300 250\n"), std::string::npos);
  EXPECT_EQ(text.rfind("HOME\nRACK:0\n", 0), 0u);
}

TEST(Kcode, WhatWasWrittenIsReadBack) {
  const std::vector<KcodePass> sweeps = plan(
      "in 2\ntuck + f100 2\ntuck + b103 2\nknit - b103 2\nrack -2\nxfer f100 b102\n"
      "rack 0\nout 2\ndrop b102\ndrop b103\n");
  const KcodeText read = read_kcode(write_kcode(sweeps, 252), 252);
  EXPECT_TRUE(read.problems.empty());
  ASSERT_EQ(read.passes.size(), sweeps.size());
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    const KcodePass &a = read.passes[s], &b = sweeps[s];
    EXPECT_TRUE(a.kind == b.kind && a.direction == b.direction &&
                a.front_tucks == b.front_tucks && a.rear_tucks == b.rear_tucks &&
                a.racking == b.racking && a.front == b.front && a.rear == b.rear &&
                a.carrier == b.carrier && a.carrier_left == b.carrier_left &&
                a.carrier_right == b.carrier_right && a.carriage_left == b.carriage_left &&
                a.carriage_right == b.carriage_right && a.front_size == b.front_size &&
                a.rear_size == b.rear_size && a.speed == b.speed && a.roller == b.roller)
        << "sweep " << s;
  }
}

TEST(Kcode, HalfRackingsAreWrittenAsSuch) {
  EXPECT_NE(write_kcode(plan("rack 0.5\ndrop f10\n"), 252).find("\nRACK:0.5\n"),
            std::string::npos);
  EXPECT_NE(write_kcode(plan("rack -0.5\ndrop f10\n"), 252).find("\nRACK:-0.5\n"),
            std::string::npos);
}

TEST(Kcode, WhatSuchFilesCannotHoldIsRefused) {
  for (const char* operations :
       {"in 2\nsplit + f10 b10 2\n", "inhook 2\n", "xfer f10 bs10\n", "pause\n", "drop f253\n",
        "drop f0\n", "in 2 3\nknit + f10 2 3\n", "rack 0.25\n",
        "x-roller-advance many\ndrop f10\n"})
    EXPECT_THROW(plan(operations), InvalidInput) << operations;
}

TEST(Kcode, NoTextMakesTheReaderThrow) {
  const std::string good = write_kcode(
      plan("in 2\ntuck + f100 2\nknit - f100 2\nrack 2\nxfer f100 b98\nrack 0\nout 2\n"
           "drop b98\n"),
      252);
  ASSERT_TRUE(read_kcode(good, 252).problems.empty());
  for (std::size_t end = 0; end < good.size(); end += 7)
    read_kcode(std::string_view(good).substr(0, end), 252);
  for (std::size_t at = 0; at < good.size(); at += 5)
    for (const char c : {'-', '9', '/', '\n', '>', '.'}) {
      std::string damaged = good;
      damaged[at] = c;
      for (const Problem& p : read_kcode(damaged, 252).problems)
        ASSERT_FALSE(p.message.empty() || p.remedy.empty());
    }
}

}  // namespace
}  // namespace meshknit
