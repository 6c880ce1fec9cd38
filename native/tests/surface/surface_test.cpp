#include "meshknit/surface/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meshknit/core/error.h"
#include "surface/test_meshes.h"

namespace meshknit {
namespace {

Surface surface_of(const MeshArrays& arrays) {
  return make_surface(arrays.vertices, arrays.faces);
}

void add_face(MeshArrays& arrays, int a, int b, int c) {
  arrays.faces.conservativeResize(arrays.faces.rows() + 1, 3);
  arrays.faces.row(arrays.faces.rows() - 1) << a, b, c;
}

int add_vertex(MeshArrays& arrays, double x, double y, double z) {
  arrays.vertices.conservativeResize(arrays.vertices.rows() + 1, 3);
  arrays.vertices.row(arrays.vertices.rows() - 1) << x, y, z;
  return static_cast<int>(arrays.vertices.rows()) - 1;
}

TEST(MakeSurface, ATubeHasTwoOpeningsAndNoProblem) {
  const Surface surface = surface_of(tube());
  EXPECT_TRUE(surface.problems.empty());
  EXPECT_EQ(surface.boundaries.size(), 2u);
  EXPECT_EQ(surface.genus, 0);
  EXPECT_EQ(surface.components, 1);
  // A prism of 24 sides with chord 2 * 20 sin(pi / 24), 100 long.
  const double chord = 40.0 * std::sin(3.141592653589793 / 24);
  EXPECT_NEAR(surface.boundaries[0].length, 24 * chord, 1e-9);
  EXPECT_NEAR(surface.area, 24 * chord * 100.0, 1e-6);
}

TEST(MakeSurface, BoundariesRunWithTheSurfaceOnTheirLeft) {
  const Surface surface = surface_of(tube({24, 12}));
  // Normals point out and the lower rim has the cloth above it: seen from outside with the
  // cloth on the left it runs rightward, which is anticlockwise seen from above. The upper rim
  // runs the other way.
  std::vector<int> rising, falling = {12 * 24};
  for (int i = 0; i < 24; ++i) rising.push_back(i);
  for (int i = 23; i > 0; --i) falling.push_back(12 * 24 + i);
  EXPECT_EQ(surface.boundaries[0].vertices, rising);
  EXPECT_EQ(surface.boundaries[1].vertices, falling);
}

TEST(MakeSurface, TorusWithTwoHolesHasOneHandle) {
  const MeshArrays closed = closed_torus();
  const MeshArrays open = without_quads(closed, {0, 1, 2, 3, 4, 200, 201, 202, 203, 204});
  const Surface surface = surface_of(open);
  EXPECT_FALSE(has_errors(surface.problems));
  EXPECT_EQ(surface.boundaries.size(), 2u);
  EXPECT_EQ(surface.genus, 1);

  const Surface without = surface_of(closed);
  EXPECT_NE(find_problem(without.problems, "too-few-boundaries"), nullptr);
  EXPECT_EQ(without.genus, 1);
}

TEST(MakeSurface, ATorusCutOpenIsKnitFromCutToCut) {
  const Surface surface = surface_of(cut_torus());
  EXPECT_TRUE(surface.problems.empty()) << surface.problems.front().message;
  EXPECT_EQ(surface.boundaries.size(), 2u);
  EXPECT_EQ(surface.genus, 0);
}

TEST(MakeSurface, TriangleSoupIsSewnTogether) {
  const MeshArrays whole = tube();
  const Surface surface = surface_of(triangle_soup(whole));
  EXPECT_FALSE(has_errors(surface.problems));
  EXPECT_NE(find_problem(surface.problems, "doubled-vertices"), nullptr);
  EXPECT_EQ(surface.mesh.n_vertices(), static_cast<std::size_t>(whole.vertices.rows()));
  EXPECT_EQ(surface.boundaries.size(), 2u);
  for (std::size_t v = 0; v < surface.vertex_of_source.size(); ++v) {
    ASSERT_GE(surface.vertex_of_source[v], 0);
    EXPECT_LE(surface.source_vertex[surface.vertex_of_source[v]], static_cast<int>(v));
  }
}

TEST(MakeSurface, ASeamAlongATubeIsClosed) {
  // One more column of vertices on top of the first: the tube is slit from end to end.
  MeshArrays slit = tube();
  for (int ring = 0; ring <= 12; ++ring) {
    const Eigen::RowVector3d at = slit.vertices.row(ring * 24);
    add_vertex(slit, at.x(), at.y() + 1e-9, at.z());
  }
  const int first_copy = 13 * 24;
  for (int quad = 23; quad < 12 * 24;
       quad += 24)  // the quads from the last column to the first
    for (Eigen::Index f = 2 * quad; f < 2 * quad + 2; ++f)
      for (int k = 0; k < 3; ++k)
        if (slit.faces(f, k) % 24 == 0) slit.faces(f, k) = first_copy + slit.faces(f, k) / 24;
  const Surface surface = surface_of(slit);
  EXPECT_FALSE(has_errors(surface.problems));
  const Problem* note = find_problem(surface.problems, "doubled-vertices");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->elements.vertices.size(), 13u);
  EXPECT_EQ(surface.boundaries.size(), 2u);
}

TEST(MakeSurface, TwoPartsWithMatchingRimsAreSewnButPartsThatTouchInAPointAreNot) {
  const MeshArrays one = tube();
  const Surface stacked = surface_of(side_by_side(one, one, {0.0, 0.0, 100.0}));
  EXPECT_FALSE(has_errors(stacked.problems));
  EXPECT_EQ(stacked.components, 1);
  // Moved aside by a diameter, they share the place of one vertex of each rim.
  const Surface touching = surface_of(side_by_side(one, one, {40.0, 0.0, 0.0}));
  EXPECT_EQ(find_problem(touching.problems, "doubled-vertices"), nullptr);
  EXPECT_EQ(touching.components, 2);
}

TEST(MakeSurface, WhereThreeRimsCoincideNobodyCanTellWhichTwoBelongTogether) {
  TubeShape flared;
  flared.radius = [](double z) { return 20.0 + z; };
  const MeshArrays two = side_by_side(tube(), tube(), {0.0, 0.0, -100.0});
  const Surface surface = surface_of(side_by_side(two, tube(flared), {0.0, 0.0, 0.0}));
  EXPECT_EQ(find_problem(surface.problems, "doubled-vertices"), nullptr);
  EXPECT_EQ(surface.components, 3);
}

TEST(MakeSurface, SeveralPiecesAreRefusedNamingTheSmallOnes) {
  MeshArrays small = tube({6, 2});
  const Surface surface = surface_of(side_by_side(small, tube(), {200.0, 0.0, 0.0}));
  const Problem* problem = find_problem(surface.problems, "several-components");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->severity, Severity::error);
  EXPECT_EQ(problem->elements.faces.size(), static_cast<std::size_t>(small.faces.rows()));
  EXPECT_EQ(problem->elements.faces.front(), 0);
}

TEST(MakeSurface, TheFewerFlippedFacesAreTurned) {
  MeshArrays arrays = tube();
  for (const int f : {3, 40, 41}) std::swap(arrays.faces(f, 0), arrays.faces(f, 1));
  const Surface surface = surface_of(arrays);
  const Problem* note = find_problem(surface.problems, "flipped-faces");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->severity, Severity::note);
  EXPECT_EQ(note->elements.faces, (std::vector<int>{3, 40, 41}));
  EXPECT_FALSE(has_errors(surface.problems));
  for (const auto f : surface.mesh.faces()) {
    const Eigen::Vector3d centre = surface.mesh.calc_face_centroid(f);
    const Eigen::Vector3d outward(centre.x(), centre.y(), 0.0);
    EXPECT_GT(surface.mesh.calc_face_normal(f).dot(outward), 0.0);
  }
}

TEST(MakeSurface, AMoebiusBandIsRefused) {
  // A strip of 20 quads, its end joined to its start upside down.
  MeshArrays band;
  for (int i = 0; i < 20; ++i)
    for (const double side : {-15.0, 15.0}) {
      const double a = 6.283185307179586 * i / 20, lean = a / 2;
      const double radius = 80.0 + side * std::cos(lean);
      add_vertex(band, radius * std::cos(a), radius * std::sin(a), side * std::sin(lean));
    }
  for (int i = 0; i < 20; ++i) {
    const bool last = i == 19;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    add_face(band, a, c, d);
    add_face(band, a, d, b);
  }
  const Surface surface = surface_of(band);
  const Problem* problem = find_problem(surface.problems, "not-orientable");
  ASSERT_NE(problem, nullptr);
  EXPECT_FALSE(problem->elements.edges.empty());
}

TEST(MakeSurface, AnHourglassIsRefusedAtItsWaist) {
  TubeShape cone;
  cone.radius = [](double z) { return std::abs(z - 50.0); };  // ring 6 of 12 shrinks to a point
  MeshArrays arrays = tube(cone);
  for (Eigen::Index i = 0; i < arrays.faces.size(); ++i) {
    int& v = arrays.faces.data()[i];
    if (v / 24 == 6) v = 6 * 24;
  }
  const Surface surface = surface_of(arrays);
  const Problem* problem = find_problem(surface.problems, "nonmanifold-vertex");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->elements.vertices, std::vector<int>{6 * 24});
}

TEST(MakeSurface, AFinIsRefusedAtItsEdge) {
  MeshArrays arrays = tube();
  const int tip = add_vertex(arrays, 60.0, 5.0, 50.0);
  add_face(arrays, 6 * 24, 6 * 24 + 1, tip);
  const Surface surface = surface_of(arrays);
  const Problem* problem = find_problem(surface.problems, "nonmanifold-edge");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->elements.edges, (std::vector<std::array<int, 2>>{{6 * 24, 6 * 24 + 1}}));
}

TEST(MakeSurface, RepeatedFacesAndUnusedVerticesAreLeftOut) {
  MeshArrays arrays = tube();
  const auto faces = static_cast<std::size_t>(arrays.faces.rows());
  add_face(arrays, arrays.faces(5, 1), arrays.faces(5, 2), arrays.faces(5, 0));
  add_face(arrays, arrays.faces(5, 1), arrays.faces(5, 0), arrays.faces(5, 2));
  const int loose = add_vertex(arrays, 0.0, 0.0, 0.0);
  const Surface surface = surface_of(arrays);
  EXPECT_FALSE(has_errors(surface.problems));
  EXPECT_EQ(find_problem(surface.problems, "repeated-face")->elements.faces.size(), 2u);
  EXPECT_EQ(find_problem(surface.problems, "unused-vertices")->elements.vertices,
            std::vector<int>{loose});
  EXPECT_EQ(surface.vertex_of_source[loose], -1);
  EXPECT_EQ(surface.mesh.n_faces(), faces);
}

TEST(MakeSurface, FacesWithoutAreaAreRefusedUnlessTheyCollapse) {
  MeshArrays arrays = tube();
  // Vertex 1 of face 0 moves into the middle of the opposite side, where it makes a flat
  // triangle.
  const int face = 2 * (5 * 24 + 3);
  arrays.vertices.row(arrays.faces(face, 1)) =
      0.5 *
      (arrays.vertices.row(arrays.faces(face, 0)) + arrays.vertices.row(arrays.faces(face, 2)));
  const Surface flat = surface_of(arrays);
  const Problem* problem = find_problem(flat.problems, "zero-area-face");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->severity, Severity::error);
  EXPECT_EQ(problem->elements.faces, std::vector<int>{face});

  MeshArrays harmless = tube();
  add_face(harmless, 30, 31, 30);
  const Surface mended = surface_of(harmless);
  EXPECT_FALSE(has_errors(mended.problems));
  EXPECT_EQ(find_problem(mended.problems, "zero-area-face")->severity, Severity::note);
}

TEST(MakeSurface, AnOpeningMustHoldARow) {
  TubeShape bottle;
  bottle.radius = [](double z) { return 20.0 - 0.17 * z; };  // 3 mm at the top
  const Surface surface = surface_of(tube(bottle));
  const Problem* problem = find_problem(surface.problems, "short-boundary");
  ASSERT_NE(problem, nullptr);  // about 19 mm round, six stitches are 22
  EXPECT_EQ(problem->elements.boundaries, std::vector<int>{1});
  EXPECT_EQ(make_surface(tube(bottle).vertices, tube(bottle).faces, {2.0, 6}).problems.size(),
            0u)
      << "finer stitches fit";
}

TEST(MakeSurface, NothingAndNonsense) {
  EXPECT_NE(find_problem(make_surface({}, {}).problems, "empty-mesh"), nullptr);
  MeshArrays arrays = tube();
  arrays.vertices(17, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_problem(surface_of(arrays).problems, "not-finite")->elements.vertices,
            std::vector<int>{17});
  arrays.faces(0, 0) = 100000;
  EXPECT_THROW(surface_of(arrays), InvalidInput);
}

}  // namespace
}  // namespace meshknit
