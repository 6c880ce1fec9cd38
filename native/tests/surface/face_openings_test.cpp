#include <gtest/gtest.h>

#include <algorithm>

#include "meshknit/surface/openings.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

// A tube 60 mm wide: 24 quads of about 7.9 x 8.3 mm round, 12 along; quad q is faces 2 q, 2 q + 1.
MeshArrays wide_tube() {
  TubeShape shape;
  shape.radius = [](double) { return 30.0; };
  return tube(shape);
}

std::vector<int> marked(const MeshArrays& arrays,
                        const std::vector<std::pair<int, int>>& quad_and_number) {
  std::vector<int> marks(static_cast<std::size_t>(arrays.faces.rows()), 0);
  for (const auto& [quad, number] : quad_and_number)
    marks[2 * quad] = marks[2 * quad + 1] = number;
  return marks;
}

int quad(int ring, int column) { return 24 * ring + column; }

CutSurface cut(const MeshArrays& arrays, const std::vector<int>& face_marks,
               const std::vector<OpeningMark>& marks = {}) {
  CutSurface result = cut_openings(arrays.vertices, arrays.faces, face_marks, marks);
  for (const Problem& p : check_cut(arrays.vertices, arrays.faces, marks, result))
    ADD_FAILURE() << p.code;
  return result;
}

std::string error_of(const CutSurface& result) {
  for (const Problem& p : result.problems)
    if (p.severity == Severity::error) return p.code;
  return "";
}

TEST(FaceOpenings, IslandsOfMarkedFacesAreOpenings) {
  const MeshArrays arrays = wide_tube();
  const CutSurface result = cut(
      arrays,
      marked(arrays, {{quad(7, 3), 2}, {quad(7, 4), 2}, {quad(3, 10), 5}, {quad(3, 15), 2}}));
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.openings.size(), 3u);
  // In the order of their first faces: ring 3 comes before ring 7.
  EXPECT_EQ(result.openings[0].face_mark, 5);
  EXPECT_EQ(result.openings[1].face_mark, 2);
  EXPECT_EQ(result.openings[2].faces, (std::vector<int>{2 * quad(7, 3), 2 * quad(7, 3) + 1,
                                                        2 * quad(7, 4), 2 * quad(7, 4) + 1}));
  EXPECT_EQ(result.openings[0].rim.size(), 4u);
  EXPECT_EQ(result.openings[2].rim.size(), 6u);
  EXPECT_EQ(result.faces.rows(), arrays.faces.rows() - 8);
  EXPECT_EQ(make_surface(result.vertices, result.faces).boundaries.size(), 5u);
}

TEST(FaceOpenings, GoTogetherWithMarks) {
  const MeshArrays arrays = wide_tube();
  const CutSurface result =
      cut(arrays, marked(arrays, {{quad(3, 10), 1}}), {{{30.0, 0.0, 70.0}, 10.0}});
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.openings.size(), 2u);
  EXPECT_EQ(result.openings[0].mark, 0);
  EXPECT_EQ(result.openings[1].mark, -1);
  EXPECT_EQ(
      error_of(cut(arrays, marked(arrays, {{quad(8, 0), 1}}), {{{30.0, 0.0, 70.0}, 10.0}})),
      "openings-overlap");
}

TEST(FaceOpenings, AMarkBesideThemDoesNotMakeThemTwo) {
  // Round the mark the mesh is refined, and so are the marked faces beside it.
  const MeshArrays arrays = wide_tube();
  const CutSurface result = cut(arrays, marked(arrays, {{quad(7, 3), 1}, {quad(8, 3), 1}}),
                                {{{30.0, 0.0, 70.0}, 20.0}});
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.openings.size(), 2u);
  EXPECT_EQ(result.openings[1].faces.size(), 4u);
}

TEST(FaceOpenings, IslandsThatTouchInAPointAreRefused) {
  const MeshArrays arrays = wide_tube();
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, {{quad(4, 4), 1}, {quad(5, 5), 1}}))),
            "openings-touch");
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, {{quad(4, 4), 1}, {quad(4, 5), 2}}))),
            "openings-touch");
}

TEST(FaceOpenings, AnIslandThatMeetsItselfIsRefused) {
  // A ring of quads open at one corner: its ends touch in a point.
  const MeshArrays arrays = wide_tube();
  std::vector<std::pair<int, int>> ring;
  for (const auto& [r, c] :
       {std::pair<int, int>{4, 4}, {4, 5}, {4, 6}, {5, 6}, {6, 6}, {6, 5}, {5, 4}})
    ring.push_back({quad(r, c), 1});
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, ring))), "opening-not-a-disc");
}

TEST(FaceOpenings, ABandRoundATubeIsNoOpening) {
  const MeshArrays arrays = wide_tube();
  std::vector<std::pair<int, int>> band;
  for (int c = 0; c < 24; ++c) band.push_back({quad(6, c), 1});
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, band))), "opening-not-a-disc");
}

TEST(FaceOpenings, TheLastRowOfATubeMayBeLeftOut) {
  const MeshArrays arrays = wide_tube();
  std::vector<std::pair<int, int>> last;
  for (int c = 0; c < 24; ++c) last.push_back({quad(11, c), 1});
  const CutSurface result = cut(arrays, marked(arrays, last));
  EXPECT_TRUE(result.problems.empty());
  ASSERT_EQ(result.openings.size(), 1u);
  EXPECT_EQ(result.openings[0].rim.size(), 24u);
  EXPECT_EQ(make_surface(result.vertices, result.faces).boundaries.size(), 2u);
}

TEST(FaceOpenings, OneQuadIsTooSmallForSixStitches) {
  // The quads of a tube of radius 10 are 2.6 x 8.3 mm: 21.9 mm round, and 21.96 mm are needed.
  TubeShape shape;
  shape.radius = [](double) { return 10.0; };
  const MeshArrays arrays = tube(shape);
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, {{quad(4, 4), 1}}))), "opening-too-small");
  EXPECT_EQ(error_of(cut(arrays, marked(arrays, {{quad(4, 4), 1}, {quad(4, 5), 1}}))), "");
}

TEST(FaceOpenings, SomethingMustBeLeft) {
  const MeshArrays arrays = wide_tube();
  const std::vector<int> all(static_cast<std::size_t>(arrays.faces.rows()), 1);
  EXPECT_EQ(error_of(cut(arrays, all)), "opening-swallows-part");
}

TEST(FaceOpenings, AWholePieceMayBeLeftOut) {
  // A ball beside the tube, as an eye of a toy that is sewn on afterwards.
  const MeshArrays eye = ball(5.0, 1);
  const MeshArrays arrays = side_by_side(wide_tube(), eye, {60.0, 0.0, 0.0});
  std::vector<int> marks(static_cast<std::size_t>(arrays.faces.rows()), 0);
  std::fill(marks.end() - eye.faces.rows(), marks.end(), 3);
  const CutSurface result = cut(arrays, marks);
  EXPECT_EQ(error_of(result), "");
  EXPECT_NE(find_problem(result.problems, "part-left-out"), nullptr);
  EXPECT_TRUE(result.openings.empty());
  EXPECT_TRUE(make_surface(result.vertices, result.faces).problems.empty());
}

}  // namespace
}  // namespace meshknit
