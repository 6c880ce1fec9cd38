// Stitches that are added where edges are stretched.

#include "meshknit/remesh/even_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/finish_graph.h"
#include "meshknit/remesh/stretch.h"
#include "meshknit/remesh/walk.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

// A tube of radius 20 and 80 mm high with rows drawn on it, their columns straight up.
struct DrawnRows {
  TriangleMesh mesh = half_edges(tube({48, 32, 80.0, [](double) { return 20.0; }}));
  std::vector<double> time;
  std::vector<int> faces;
  KnitGraph graph;

  // Node i of row r lies `height(i, r)` above the first row.
  template <class Height>
  DrawnRows(int nodes, int rows, const Height& height) {
    for (const auto v : mesh.vertices()) time.push_back(mesh.point(v).z() / 40.0 - 1.0);
    const FacePoint origin =
        walk(mesh, {0, mesh.calc_face_centroid(TriangleMesh::FaceHandle(0))}, {0.0, 0.0, 3.0});
    const Eigen::Vector3d across =
        Eigen::Vector3d::UnitZ().cross(mesh.calc_face_normal(mesh.face_handle(0))).normalized();
    const double round = 48.0 * 40.0 * std::sin(pi / 48.0);
    for (int r = 0; r < rows; ++r) {
      KnitRow row;
      for (int i = 0; i < nodes; ++i) {
        const FacePoint at = walk(
            mesh, origin, i * round / nodes * across + height(i, r) * Eigen::Vector3d::UnitZ());
        row.nodes.push_back(nodes * r + i);
        graph.nodes.push_back({at.position, 0.0});
        faces.push_back(at.face);
        if (r > 0) graph.columns.push_back({nodes * (r - 1) + i, nodes * r + i});
      }
      graph.rows.push_back(row);
    }
    graph.stitch_width = round / nodes;
    graph.stitch_height = 4.0;
  }

  void even_out() {
    even_edges(mesh, time, faces, graph);
    finish_graph(mesh, faces, graph);
  }
};

void expect_no_errors(const KnitGraph& graph) {
  for (const Problem& problem : check_knit_graph(graph).problems)
    EXPECT_NE(problem.severity, Severity::error) << problem.message;
}

double longest_column(const KnitGraph& graph) {
  return *std::max_element(graph.column_lengths.begin(), graph.column_lengths.end());
}

// Eight rows, 8 mm apart; on one half of the tube the rows from the fourth on stand a row higher, with
// half a row's step on either side.
double with_a_gap(int i, int r) {
  const double higher[] = {0, 0, 0, 0, 0.5, 1, 1, 1,   1, 1, 1, 1,
                           1, 1, 1, 1, 1,   1, 1, 0.5, 0, 0, 0, 0};
  return 8.0 * (r + (r >= 3 ? higher[i] : 0.0));
}

TEST(EvenEdges, AddsNothingWhereAllIsAsItShouldBe) {
  DrawnRows drawn(24, 8, [](int, int r) { return 8.0 * r; });
  const KnitGraph before = drawn.graph;
  drawn.even_out();
  EXPECT_EQ(drawn.graph.columns, before.columns);
  EXPECT_NEAR(longest_column(drawn.graph), 8.0, 0.01);
}

TEST(EvenEdges, KnitsAShortRowWhereARowIsMissing) {
  DrawnRows drawn(24, 8, with_a_gap);
  drawn.even_out();
  expect_no_errors(drawn.graph);
  ASSERT_EQ(drawn.graph.rows.size(), 9u);
  const auto short_row = std::find_if(drawn.graph.rows.begin(), drawn.graph.rows.end(),
                                      [](const KnitRow& row) { return !row.closed; });
  ASSERT_NE(short_row, drawn.graph.rows.end());
  // 14 stitches stand a whole row higher; on either side another lies half way.
  EXPECT_NEAR(static_cast<double>(short_row->nodes.size()), 15.0, 2.0);
  EXPECT_LT(longest_column(drawn.graph), 1.1 * 8.0);
}

TEST(EvenEdges, KnitsAWaleWhereRowsAreStretched) {
  // Rows of five stitches where six would fit: between the first row and the last, one more fits in.
  DrawnRows drawn(5, 9, [](int, int r) { return 8.0 * r; });
  drawn.graph.stitch_width *= 5.0 / 6.0;
  drawn.even_out();
  expect_no_errors(drawn.graph);
  EXPECT_EQ(drawn.graph.rows.front().nodes.size(), 5u);
  EXPECT_EQ(drawn.graph.rows[4].nodes.size(), 6u);
  EXPECT_EQ(drawn.graph.rows.back().nodes.size(), 5u);
  const KnitGraphStats stats = measure_graph(drawn.graph);
  EXPECT_EQ(stats.increases, 1);
  EXPECT_EQ(stats.decreases, 1);
}

TEST(EvenEdges, CanBeCancelledAtAnyTime) {
  int told = 0;
  DrawnRows all(24, 8, with_a_gap);
  double last = -1.0;
  even_edges(all.mesh, all.time, all.faces, all.graph, [&](double fraction) {
    EXPECT_GT(fraction, last);
    EXPECT_LE(last = fraction, 1.0);
    ++told;
  });
  // Once every round of relaxing and before every trial.
  EXPECT_GT(told, 100);
  for (const int when : {1, told / 2, told - 1}) {
    DrawnRows drawn(24, 8, with_a_gap);
    int count = 0;
    EXPECT_THROW(even_edges(drawn.mesh, drawn.time, drawn.faces, drawn.graph,
                            [&](double) {
                              if (++count == when) throw Cancelled();
                            }),
                 Cancelled);
  }
}

TEST(Stretch, SumsUpWhatIsMissing) {
  // Columns 20 % too long: of the seven edges from three below to three above, 1.4 stitches.
  DrawnRows drawn(24, 9, [](int, int r) { return 8.0 * r; });
  const EditableGraph graph(drawn.graph);
  SurfaceSprings points(drawn.mesh);
  for (std::size_t i = 0; i < drawn.faces.size(); ++i)
    points.add({drawn.faces[i], drawn.graph.nodes[i].position});
  const Stretch stretch(graph, points, {drawn.graph.stitch_width, 8.0 / 1.2});
  EXPECT_NEAR(stretch.error(4 * 24, EdgeKind::column), 0.2, 1e-9);
  EXPECT_NEAR(stretch.lack(4 * 24, EdgeKind::column), 1.4, 1e-9);
  // Straight lines across an arc of 15 degrees are 0.4 % short.
  EXPECT_NEAR(stretch.lack(4 * 24, EdgeKind::row), 0.0, 7 * 0.005);
  EXPECT_EQ(stretch.edges(0.19).size(), drawn.graph.columns.size());
  EXPECT_TRUE(stretch.edges(0.21).empty());
}

}  // namespace
}  // namespace meshknit
