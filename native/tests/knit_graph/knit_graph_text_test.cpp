#include "knit_graph/knit_graph_text.h"

#include <gtest/gtest.h>

#include "graphs.h"
#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"

namespace meshknit {
namespace {

TEST(KnitGraphText, WhatIsWrittenReadsBackToTheLastBit) {
  for (int seed = 0; seed < 20; ++seed) {
    KnitGraph graph = random_tube(seed);
    graph.nodes[1].position = {1.0 / 3.0, -1e-17, 12345678.9};
    const KnitGraph read = read_knit_graph(write_knit_graph(graph));
    ASSERT_EQ(read.nodes.size(), graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      EXPECT_EQ(read.nodes[i].position, graph.nodes[i].position);
      EXPECT_EQ(read.nodes[i].time, graph.nodes[i].time);
    }
    ASSERT_EQ(read.rows.size(), graph.rows.size());
    for (std::size_t r = 0; r < graph.rows.size(); ++r) {
      EXPECT_EQ(read.rows[r].nodes, graph.rows[r].nodes);
      EXPECT_EQ(read.rows[r].closed, graph.rows[r].closed);
    }
    EXPECT_EQ(read.columns, graph.columns);
    EXPECT_EQ(read.row_lengths, graph.row_lengths);
    EXPECT_EQ(read.column_lengths, graph.column_lengths);
    EXPECT_EQ(read.stitch_width, graph.stitch_width);
  }
}

TEST(KnitGraphText, AGraphCanBeDrawnByHand) {
  const KnitGraph graph = read_knit_graph(
      "# the smallest tube\n"
      "knit-graph 1\n"
      "stitch 4 2\n"
      "\n"
      "node 0 0 0 -1\nnode 4 0 0 -1\nnode 2 3 0 -1   # first row\n"
      "node 0 0 4 1\nnode 4 0 4 1\nnode 2 3 4 1\n"
      "closed 0 1 2 lengths 4 4 4\nclosed 3 4 5 lengths 4 4 4\n"
      "column 0 3 4\ncolumn 1 4 4\ncolumn 2 5 4\n");
  EXPECT_TRUE(check_knit_graph(graph).problems.empty());
}

TEST(KnitGraphText, ErrorsNameTheLine) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      read_knit_graph(text);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("").find("line 1"), std::string::npos);
  EXPECT_NE(message("knit-graph 2\n").find("line 1"), std::string::npos);
  EXPECT_NE(message("knit-graph 1\nnode 0 0 zero 1\n").find("line 2"), std::string::npos);
  EXPECT_NE(message("knit-graph 1\n\nnode 0 0 0\n").find("line 3"), std::string::npos);
  EXPECT_NE(message("knit-graph 1\ncolumn 0 1 2 3\n").find("line 2"), std::string::npos);
  EXPECT_NE(message("knit-graph 1\nclosed 0 1 2\n").find("line 2"), std::string::npos);
  EXPECT_NE(message("knit-graph 1\npurl 0\n").find("purl"), std::string::npos);
}

}  // namespace
}  // namespace meshknit
