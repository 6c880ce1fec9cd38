#include "meshknit/knitout/knitout_reader.h"

#include <gtest/gtest.h>

#include <string>

namespace meshknit {
namespace {

const std::string kHead = ";!knitout-2\n;;Carriers: 1 2 3\n";

KnitoutText read_line(const std::string& line) { return read_knitout(kHead + line + "\n"); }

// The one problem that a line raises.
std::string complaint(const std::string& line) {
  const KnitoutText text = read_line(line);
  if (text.problems.size() != 1) {
    return std::to_string(text.problems.size()) + " problems";
  }
  EXPECT_EQ(text.problems[0].elements.lines, std::vector<int>{3});
  return text.problems[0].code;
}

TEST(KnitoutReader, ReadsAKnitWithItsStitch) {
  const KnitoutText text = read_line("knit -\tfs-3   1 2 ;!source: stitch 17");
  ASSERT_TRUE(text.problems.empty());
  ASSERT_EQ(text.program.instructions.size(), 1u);
  const Instruction& i = text.program.instructions[0];
  EXPECT_EQ(i.op, Op::knit);
  EXPECT_EQ(i.direction, Side::left);
  EXPECT_EQ(i.needle, (Needle{Bed::front, -3, true}));
  EXPECT_EQ(i.carriers, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(i.source.kind, Source::Kind::stitch);
  EXPECT_EQ(i.source.stitch, 17);
  EXPECT_EQ(i.line, 3);
}

TEST(KnitoutReader, OperationsWithoutYarnAreNamedByWhatTheyDo) {
  EXPECT_EQ(read_line("knit - f1").program.instructions.at(0).op, Op::drop);
  EXPECT_EQ(read_line("tuck + f1").program.instructions.at(0).op, Op::amiss);
  const Instruction moved = read_line("split - f1 b2").program.instructions.at(0);
  EXPECT_EQ(moved.op, Op::xfer);
  EXPECT_EQ(moved.target, (Needle{Bed::back, 2, false}));
}

TEST(KnitoutReader, CommentsOtherThanSourcesNameNothing) {
  for (const char* comment :
       {";stitch 3", ";!source: stitch -3", ";!source: stitch", ";!source: yarn",
        ";!source: stitch 3 4", ";!source: stitch 99999999999999"}) {
    const KnitoutText text = read_line(std::string("drop f1 ") + comment);
    ASSERT_EQ(text.program.instructions.size(), 1u) << comment;
    EXPECT_EQ(text.program.instructions[0].source.kind, Source::Kind::none) << comment;
  }
}

TEST(KnitoutReader, EveryKindOfBadLineIsNamed) {
  EXPECT_EQ(complaint("purl + f1 1"), "unknown-operation");
  EXPECT_EQ(complaint("knit f1 1"), "bad-direction");
  EXPECT_EQ(complaint("knit + g1 1"), "bad-needle");
  EXPECT_EQ(complaint("knit + f 1"), "bad-needle");
  EXPECT_EQ(complaint("knit + f99999999999 1"), "bad-needle");
  EXPECT_EQ(complaint("knit +"), "bad-arguments");
  EXPECT_EQ(complaint("knit + f1 4"), "carrier-not-declared");
  EXPECT_EQ(complaint("knit + f1 1 1"), "carrier-twice");
  EXPECT_EQ(complaint("drop f1 1"), "bad-arguments");
  EXPECT_EQ(complaint("miss + f1"), "no-carrier");
  EXPECT_EQ(complaint("inhook"), "no-carrier");
  EXPECT_EQ(complaint("rack"), "bad-racking");
  EXPECT_EQ(complaint("rack 1e0"), "bad-racking");
  EXPECT_EQ(complaint("rack nan"), "bad-racking");
  EXPECT_EQ(complaint("rack --1"), "bad-racking");
  EXPECT_EQ(complaint("stitch 5"), "bad-arguments");
  EXPECT_EQ(complaint("drop f1\r"), "bad-line-end");
  EXPECT_EQ(complaint(";;Machine: SWG091N2"), "0 problems");
  EXPECT_EQ(complaint(";;Position: Middle"), "bad-header");
  EXPECT_EQ(complaint(";;Carriers: 1"), "duplicate-header");
}

TEST(KnitoutReader, UnknownExtensionsAreKeptWithAWarning) {
  const KnitoutText text =
      read_knitout(";!knitout-2\n;;Carriers: 1\n;;X-Mood: calm\nx-sing loud ;!source: waste\n");
  EXPECT_FALSE(has_errors(text.problems));
  EXPECT_NE(find_problem(text.problems, "unknown-header"), nullptr);
  EXPECT_NE(find_problem(text.problems, "unknown-extension"), nullptr);
  EXPECT_EQ(text.program.instructions.at(0).text, "x-sing loud");
  EXPECT_EQ(text.program.headers.at(0).second, "calm");
}

TEST(KnitoutReader, AFileNeedsItsFirstLineAndItsCarriers) {
  for (const char* text : {"", "\n", "knit + f1 1\n", ";!knitout-3\n"}) {
    const Problems problems = read_knitout(text).problems;
    EXPECT_NE(find_problem(problems, "bad-first-line"), nullptr) << text;
    EXPECT_NE(find_problem(problems, "no-carriers-header"), nullptr) << text;
  }
  const Problems late = read_knitout(";!knitout-2\npause\n;;Carriers: 1\n").problems;
  EXPECT_NE(find_problem(late, "late-header"), nullptr);
  EXPECT_NE(find_problem(late, "no-carriers-header"), nullptr);
}

TEST(KnitoutReader, TextMustBeUtf8) {
  EXPECT_TRUE(read_line("; stitch \xC3\xA9").problems.empty());
  EXPECT_NE(find_problem(read_line("; stitch \xC3").problems, "not-utf8"), nullptr);
  EXPECT_NE(find_problem(read_line("; \xC0\x80").problems, "not-utf8"), nullptr);
}

}  // namespace
}  // namespace meshknit
